package org.phrenic.scene;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Surface;

/**
 * An access map as colours on the skin: the colour of skin where a target can never be reached, amber where in part of
 * a breath, green where always.
 */
public final class AccessMapField {
    private final List<Surface> surfaces;
    private final String skin;
    private final float[] freePercent;

    /** @param surfaces of the scene that the map is of */
    public AccessMapField(List<Surface> surfaces, AccessMap map) {
        this.surfaces = List.copyOf(surfaces);
        skin = surfaces.stream()
                .filter(s -> s.kind() == StructureKind.SKIN)
                .map(Surface::name)
                .findFirst()
                .orElseThrow();
        freePercent = map.freePercent();
    }

    /** Gives the renderer the values. */
    public void upload(Renderer renderer) {
        renderer.setField(skin, freePercent);
    }

    /**
     * The style that shows them: skin to be looked through, and so the organs before the target, where they are not
     * clearer already.
     */
    public SceneStyle applyTo(SceneStyle style) {
        SceneStyle shown = style.withField(
                ColourField.ACCESS, skin, new ColourScale(ColourMap.ACCESS, 0, 100, ColourField.ACCESS.unit()));
        for (Surface s : surfaces) {
            Optional<Appearance> look = shown.appearance(s.name());
            float most = maxOpacity(s.kind());
            if (look.isPresent() && most < 1) {
                float opacity = s.kind() == StructureKind.SKIN
                        ? most
                        : Math.min(most, look.get().opacity());
                shown = shown.withAppearance(s.name(), look.get().withOpacity(opacity));
            }
        }
        return shown;
    }

    private static float maxOpacity(StructureKind kind) {
        return switch (kind) {
            case SKIN -> 0.36f;
            case LIVER -> 0.42f;
            case DIAPHRAGM -> 0.18f;
            case LUNG -> 0.28f;
            default -> 1;
        };
    }
}
