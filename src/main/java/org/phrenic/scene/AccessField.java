package org.phrenic.scene;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.rehearsal.AccessMap;
import org.phrenic.simulation.Surface;

/** An access map as colours on the skin: the colour of skin where a target can never be reached, amber where in part of a breath, green where always. */
public final class AccessField {
    private final List<Surface> surfaces;
    private final String skin;
    private final float[] freePercent;

    /** @param surfaces of the scene that the map is of */
    public AccessField(List<Surface> surfaces, AccessMap map) {
        this.surfaces = List.copyOf(surfaces);
        skin = surfaces.stream()
                .filter(s -> s.kind() == StructureKind.SKIN)
                .map(Surface::name)
                .findFirst()
                .orElseThrow();
        freePercent = map.freePercent();
    }

    /** Gives the renderer the values. */
    public void colour(Renderer renderer) {
        renderer.setField(skin, freePercent);
    }

    /** The style that shows them: skin to be looked through, and so the organs before the target, where they are not clearer already. */
    public SceneStyle shown(SceneStyle style) {
        SceneStyle shown = style.withField(
                ColourField.ACCESS, skin, new ColourScale(ColourMap.FREEDOM, 0, 100, ColourField.ACCESS.unit()));
        for (Surface s : surfaces) {
            Optional<Look> look = shown.look(s.name());
            float most = mostOpaque(s.kind());
            if (look.isPresent() && most < 1) {
                float opacity = s.kind() == StructureKind.SKIN
                        ? most
                        : Math.min(most, look.get().opacity());
                shown = shown.withLook(s.name(), look.get().withOpacity(opacity));
            }
        }
        return shown;
    }

    private static float mostOpaque(StructureKind kind) {
        return switch (kind) {
            case SKIN -> 0.36f;
            case LIVER -> 0.42f;
            case DIAPHRAGM -> 0.18f;
            case LUNG -> 0.28f;
            default -> 1;
        };
    }
}
