package org.phrenic.ui.view;

import java.util.ArrayList;
import java.util.Arrays;
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
 * The style of the scene as chosen by the user, kept when the scene or the look and feel changes. Used on the event
 * dispatch thread.
 */
public final class AppearanceModel {
    /** Structures that share their settings. */
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

    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** The style with the override applied. */
    public SceneStyle style() {
        return overrideStyle.apply(style);
    }

    /** Sets a change that is applied over the chosen style, and a map that colours the skin. */
    public void overrideStyle(UnaryOperator<SceneStyle> over, Optional<AccessMapField> colours) {
        overrideStyle = over;
        accessColours = colours;
        fireChange();
    }

    Optional<AccessMapField> accessColours() {
        return accessColours;
    }

    /** The surface from which distances are measured. */
    public Optional<DistanceField> reference() {
        return reference;
    }

    public void setReference(DistanceField surface) {
        reference = Optional.of(surface);
        fireChange();
    }

    /** Groups of the scene. */
    public List<Group> groups() {
        return Arrays.stream(Group.values())
                .filter(group -> surfaces.stream().anyMatch(group::contains))
                .toList();
    }

    /** Appearance of a group: that of its first structure. */
    public Optional<Appearance> appearance(Group group) {
        return surfaces.stream()
                .filter(group::contains)
                .findFirst()
                .flatMap(surface -> style.appearance(surface.name()));
    }

    /** Takes over the surfaces of another scene; what was chosen applies to them too. */
    public void setSurfaces(List<Surface> others) {
        surfaces = others;
        style = style.withAppearances(SceneStyle.atlas(others).appearances()).withHighlighted("");
        groupChanges.forEach(this::apply);
        fireChange();
    }

    /** Changes the appearance of all structures of a group. */
    public void changeGroup(Group group, UnaryOperator<Appearance> change) {
        groupChanges.merge(group, change, (before, then) -> look -> then.apply(before.apply(look)));
        apply(group, change);
        fireChange();
    }

    private void apply(Group group, UnaryOperator<Appearance> change) {
        for (Surface surface : surfaces) {
            Optional<Appearance> before = group.contains(surface) ? style.appearance(surface.name()) : Optional.empty();
            if (before.isPresent()) {
                style = style.withAppearance(surface.name(), change.apply(before.get()));
            }
        }
    }

    /** Changes the style apart from the structures. */
    public void changeStyle(UnaryOperator<SceneStyle> change) {
        style = change.apply(style);
        fireChange();
    }

    /** Restores the default style, except the background. */
    public void reset() {
        groupChanges.clear();
        style = SceneStyle.atlas(surfaces).withBackground(style.background());
        fireChange();
    }

    private void fireChange() {
        listeners.forEach(Runnable::run);
    }

    /** Opacity of a surface; 0 if it is hidden. */
    static double opacity(SceneStyle style, Surface surface) {
        return style.appearance(surface.name())
                .filter(Appearance::visible)
                .map(Appearance::opacity)
                .orElse(0f);
    }
}
