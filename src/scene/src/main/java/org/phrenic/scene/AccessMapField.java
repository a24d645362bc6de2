package org.phrenic.scene;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.TrunkSkin;
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
 * An access map as colours on the skin. Skin colour: the path to the target is never free. Amber: it is free in part of
 * the breath. Green: it is always free.
 */
public final class AccessMapField {
    private final List<Surface> surfaces;
    private final String skin;
    private final float[] freePercent;

    /** @param surfaces surfaces of the scene for which the map is computed */
    public AccessMapField(List<Surface> surfaces, AccessMap map) {
        this.surfaces = List.copyOf(surfaces);
        skin = TrunkSkin.of(surfaces).orElseThrow().name();
        freePercent = map.freePercent();
    }

    /** Sets the access values in a renderer. */
    public void upload(Renderer renderer) {
        renderer.setField(skin, freePercent);
    }

    /** A style that shows the map on all of the skin: it and the organs in front of the target become translucent. */
    public SceneStyle applyTo(SceneStyle style) {
        return style.withClip(Optional.empty())
                .withField(ColourField.ACCESS, skin, scale())
                .withAppearances(surfaces, (s, usual) -> usual.withOpacity(opacity(s.kind(), usual)));
    }

    /** Colours of the share of a breath in which the path is free, in the window and in reports. */
    static ColourScale scale() {
        return new ColourScale(ColourMap.ACCESS, 0, 100, ColourField.ACCESS.unit());
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
