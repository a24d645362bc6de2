package org.phrenic.ui.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
        SKIN("Skin", StructureKind.SKIN),
        RIBS("Ribs", StructureKind.RIB),
        CARTILAGES("Costal cartilages", StructureKind.COSTAL_CARTILAGE),
        STERNUM("Sternum", StructureKind.STERNUM),
        SPINE("Spine", StructureKind.VERTEBRA, StructureKind.DISC),
        DIAPHRAGM("Diaphragm", StructureKind.DIAPHRAGM),
        LUNGS("Lungs", StructureKind.LUNG),
        PLEURA("Pleura", StructureKind.PLEURA),
        LIVER("Liver", StructureKind.LIVER),
        ORGANS("Organs", StructureKind.ORGAN, StructureKind.LESION),
        VESSELS("Vessels", StructureKind.VESSEL),
        MUSCLES("Muscles", StructureKind.MUSCLE),
        BONES("Other bones", StructureKind.BONE),
        OTHER("Other", StructureKind.OTHER);

        private final String label;
        private final Set<StructureKind> kinds;

        Group(String label, StructureKind... kinds) {
            this.label = label;
            this.kinds = Set.of(kinds);
        }

        public String label() {
            return label;
        }

        boolean contains(Surface surface) {
            return kinds.contains(surface.kind());
        }
    }

    /** What of an appearance is chosen for a group. */
    public enum Property {
        VISIBILITY,
        COLOUR,
        OPACITY,
        WIREFRAME
    }

    private final Map<Group, Map<Property, UnaryOperator<Appearance>>> groupChanges = new EnumMap<>(Group.class);
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

    /** The style that the user has chosen. */
    public SceneStyle chosenStyle() {
        return style;
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

    /** Takes over the surfaces of another scene, without an access map; what was chosen applies to them too. */
    public void setSurfaces(List<Surface> others) {
        surfaces = others;
        // An access map has a value for each vertex of the skin that it was computed on.
        accessColours = Optional.empty();
        style = style.withAppearances(SceneStyle.atlas(others).appearances()).withHighlighted("");
        groupChanges.forEach((group, changes) -> changes.values().forEach(change -> apply(group, change)));
        fireChange();
    }

    /**
     * Changes the appearance of all structures of a group.
     *
     * @param property the only part of the appearance that {@code change} alters, to the same value whatever it was
     */
    public void changeGroup(Group group, Property property, UnaryOperator<Appearance> change) {
        groupChanges
                .computeIfAbsent(group, chosen -> new EnumMap<>(Property.class))
                .put(property, change);
        apply(group, change);
        fireChange();
    }

    private void apply(Group group, UnaryOperator<Appearance> change) {
        List<Surface> members = surfaces.stream().filter(group::contains).toList();
        style = style.withAppearances(members, (surface, look) -> change.apply(look));
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
