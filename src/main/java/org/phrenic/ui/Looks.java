package org.phrenic.ui;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.AccessField;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.Look;
import org.phrenic.scene.SceneStyle;
import org.phrenic.simulation.Surface;

/** How the scene is to look: what was chosen in the organs dock, kept over changes of the scene and of light and dark. On the event dispatch thread. */
final class Looks {
    /** Structures that are chosen together. */
    enum Group {
        SKIN("Skin"),
        RIBS("Ribs"),
        CARTILAGES("Costal cartilages"),
        STERNUM("Sternum"),
        SPINE("Spine"),
        DIAPHRAGM("Diaphragm"),
        LUNGS("Lungs"),
        LIVER("Liver"),
        OTHER("Other");

        private final String label;

        Group(String label) {
            this.label = label;
        }

        String label() {
            return label;
        }

        private static Group of(StructureKind kind) {
            return switch (kind) {
                case SKIN -> SKIN;
                case RIB -> RIBS;
                case COSTAL_CARTILAGE -> CARTILAGES;
                case STERNUM -> STERNUM;
                case VERTEBRA, DISC -> SPINE;
                case DIAPHRAGM -> DIAPHRAGM;
                case LUNG -> LUNGS;
                case LIVER -> LIVER;
                case OTHER -> OTHER;
            };
        }

        boolean has(Surface surface) {
            return of(surface.kind()) == this;
        }
    }

    private final Map<Group, UnaryOperator<Look>> chosen = new EnumMap<>(Group.class);
    private final List<Runnable> listeners = new ArrayList<>();
    private List<Surface> surfaces = List.of();
    private SceneStyle style = SceneStyle.atlas(List.of());
    private Optional<DistanceField> reference = Optional.empty();
    private Optional<AccessField> access = Optional.empty();
    private UnaryOperator<SceneStyle> dress = UnaryOperator.identity();

    /** Told after every change. */
    void onChange(Runnable listener) {
        listeners.add(listener);
    }

    /** As it is seen: as it was chosen, and dressed over that. */
    SceneStyle style() {
        return dress.apply(style);
    }

    /** Dresses the style for a purpose, over what is chosen; nothing of that is lost. */
    void dress(UnaryOperator<SceneStyle> over, Optional<AccessField> colours) {
        dress = over;
        access = colours;
        changed();
    }

    /** The map that colours the skin; empty for none. */
    Optional<AccessField> access() {
        return access;
    }

    /** What distances are measured from; empty for nothing. */
    Optional<DistanceField> reference() {
        return reference;
    }

    /** Measures distances from a surface from now on. */
    void measureFrom(DistanceField surface) {
        reference = Optional.of(surface);
        changed();
    }

    /** Groups that the scene has. */
    List<Group> groups() {
        return java.util.Arrays.stream(Group.values())
                .filter(group -> surfaces.stream().anyMatch(group::has))
                .toList();
    }

    /** Look of a group: that of its first structure. */
    Optional<Look> look(Group group) {
        return surfaces.stream().filter(group::has).findFirst().flatMap(surface -> style.look(surface.name()));
    }

    /** Another scene: what was chosen is chosen for it too. */
    void scene(List<Surface> others) {
        surfaces = others;
        SceneStyle atlas = SceneStyle.atlas(others);
        style = carried(style, atlas);
        chosen.forEach(this::apply);
        changed();
    }

    /** What belongs to no structure goes over to the structures of another scene. */
    private static SceneStyle carried(SceneStyle before, SceneStyle atlas) {
        return atlas.withBackground(before.background())
                .withRestWireframe(before.restWireframe())
                .withField(before.field(), before.fieldOn(), before.scale())
                .withOverlays(before.overlays())
                .withClip(before.clip())
                .withTransparency(before.transparency())
                .withSamples(before.samples());
    }

    /** Changes the look of all structures of a group. */
    void choose(Group group, UnaryOperator<Look> change) {
        chosen.merge(group, change, (before, then) -> look -> then.apply(before.apply(look)));
        apply(group, change);
        changed();
    }

    private void apply(Group group, UnaryOperator<Look> change) {
        for (Surface surface : surfaces) {
            if (group.has(surface)) {
                Optional<Look> before = style.look(surface.name());
                if (before.isPresent()) {
                    style = style.withLook(surface.name(), change.apply(before.get()));
                }
            }
        }
    }

    /** Changes what is no group's. */
    void change(UnaryOperator<SceneStyle> change) {
        style = change.apply(style);
        changed();
    }

    /** All as it was at first, but light or dark. */
    void reset() {
        chosen.clear();
        style = SceneStyle.atlas(surfaces).withBackground(style.background());
        changed();
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    /** How opaque a surface is drawn; 0 if it is hidden. */
    static double opacity(SceneStyle style, Surface surface) {
        return style.look(surface.name())
                .filter(Look::visible)
                .map(Look::opacity)
                .orElse(0f);
    }
}
