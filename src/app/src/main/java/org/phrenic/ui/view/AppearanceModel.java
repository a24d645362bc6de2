package org.phrenic.ui.view;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.AccessMapField;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Surface;

/**
 * How the scene is to look: what was chosen in the organs dock, kept over changes of the scene and of light and dark.
 * On the event dispatch thread.
 */
public final class AppearanceModel {
    /** Structures that are chosen together. */
    public enum Group {
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

        public String label() {
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

        boolean contains(Surface surface) {
            return of(surface.kind()) == this;
        }
    }

    private final Map<Group, UnaryOperator<Appearance>> groupChanges = new EnumMap<>(Group.class);
    private final List<Runnable> listeners = new ArrayList<>();
    private List<Surface> surfaces = List.of();
    private SceneStyle style = SceneStyle.atlas(List.of());
    private Optional<DistanceField> reference = Optional.empty();
    private Optional<AccessMapField> accessColours = Optional.empty();
    private UnaryOperator<SceneStyle> overrideStyle = UnaryOperator.identity();

    /** Told after every change. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** As it is seen: as it was chosen, and dressed over that. */
    public SceneStyle style() {
        return overrideStyle.apply(style);
    }

    /** Dresses the style for a purpose, over what is chosen; nothing of that is lost. */
    public void overrideStyle(UnaryOperator<SceneStyle> over, Optional<AccessMapField> colours) {
        overrideStyle = over;
        accessColours = colours;
        fireChange();
    }

    /** The map that colours the skin; empty for none. */
    Optional<AccessMapField> accessColours() {
        return accessColours;
    }

    /** What distances are measured from; empty for nothing. */
    public Optional<DistanceField> reference() {
        return reference;
    }

    /** Measures distances from a surface from now on. */
    public void setReference(DistanceField surface) {
        reference = Optional.of(surface);
        fireChange();
    }

    /** Groups that the scene has. */
    public List<Group> groups() {
        return java.util.Arrays.stream(Group.values())
                .filter(group -> surfaces.stream().anyMatch(group::contains))
                .toList();
    }

    /** Look of a group: that of its first structure. */
    public Optional<Appearance> appearance(Group group) {
        return surfaces.stream()
                .filter(group::contains)
                .findFirst()
                .flatMap(surface -> style.appearance(surface.name()));
    }

    /** Another scene: what was chosen is chosen for it too. */
    public void setSurfaces(List<Surface> others) {
        surfaces = others;
        SceneStyle atlas = SceneStyle.atlas(others);
        style = carryOver(style, atlas);
        groupChanges.forEach(this::apply);
        fireChange();
    }

    /** What belongs to no structure goes over to the structures of another scene. */
    private static SceneStyle carryOver(SceneStyle before, SceneStyle atlas) {
        return atlas.withBackground(before.background())
                .withRestWireframe(before.restWireframe())
                .withField(before.field(), before.fieldStructure(), before.scale())
                .withOverlays(before.overlays())
                .withClip(before.clip())
                .withTransparency(before.transparency())
                .withSamples(before.samples());
    }

    /** Changes the look of all structures of a group. */
    public void changeGroup(Group group, UnaryOperator<Appearance> change) {
        groupChanges.merge(group, change, (before, then) -> look -> then.apply(before.apply(look)));
        apply(group, change);
        fireChange();
    }

    private void apply(Group group, UnaryOperator<Appearance> change) {
        for (Surface surface : surfaces) {
            if (group.contains(surface)) {
                Optional<Appearance> before = style.appearance(surface.name());
                if (before.isPresent()) {
                    style = style.withAppearance(surface.name(), change.apply(before.get()));
                }
            }
        }
    }

    /** Changes what is no group's. */
    public void changeStyle(UnaryOperator<SceneStyle> change) {
        style = change.apply(style);
        fireChange();
    }

    /** All as it was at first, but light or dark. */
    public void reset() {
        groupChanges.clear();
        style = SceneStyle.atlas(surfaces).withBackground(style.background());
        fireChange();
    }

    private void fireChange() {
        listeners.forEach(Runnable::run);
    }

    /** How opaque a surface is drawn; 0 if it is hidden. */
    static double opacity(SceneStyle style, Surface surface) {
        return style.appearance(surface.name())
                .filter(Appearance::visible)
                .map(Appearance::opacity)
                .orElse(0f);
    }
}
