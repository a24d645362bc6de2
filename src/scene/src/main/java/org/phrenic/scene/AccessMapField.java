package org.phrenic.scene;

import java.util.List;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureSelection;
import org.phrenic.simulation.observe.Surface;

/**
 * An access map as colours on the skin: the colour of skin where the path to a target is never free, amber where it is
 * free in part of a breath, green where always.
 */
public final class AccessMapField {
    private final List<Surface> surfaces;
    private final String skin;
    private final float[] freePercent;

    /** @param surfaces of the scene that the map is of */
    public AccessMapField(List<Surface> surfaces, AccessMap map) {
        this.surfaces = List.copyOf(surfaces);
        skin = StructureSelection.first(surfaces, StructureKind.SKIN).name();
        freePercent = map.freePercent();
    }

    /** Sets the values of a renderer. */
    public void upload(Renderer renderer) {
        renderer.setField(skin, freePercent);
    }

    /** The style that shows the map: skin and the organs before the target are made translucent. */
    public SceneStyle applyTo(SceneStyle style) {
        ColourScale scale = new ColourScale(ColourMap.ACCESS, 0, 100, ColourField.ACCESS.unit());
        return style.withField(ColourField.ACCESS, skin, scale)
                .withAppearances(surfaces, (s, usual) -> usual.withOpacity(opacity(s.kind(), usual)));
    }

    private static float opacity(StructureKind kind, Appearance usual) {
        return switch (kind) {
            case SKIN -> 0.36f;
            case LIVER -> Math.min(0.42f, usual.opacity());
            case DIAPHRAGM -> Math.min(0.18f, usual.opacity());
            case LUNG -> Math.min(0.28f, usual.opacity());
            default -> usual.opacity();
        };
    }
}
