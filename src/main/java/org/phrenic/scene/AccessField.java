package org.phrenic.scene;

import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.rehearsal.AccessMap;
import org.phrenic.simulation.Surface;

/** An access map as colours on the skin: the colour of skin where a target can never be reached, amber where in part of a breath, green where always. */
public final class AccessField {
    private final String skin;
    private final float[] freePercent;

    /** @param surfaces of the scene that the map is of */
    public AccessField(List<Surface> surfaces, AccessMap map) {
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

    /** The style that shows them. */
    public SceneStyle shown(SceneStyle style) {
        return style.withField(
                ColourField.ACCESS, skin, new ColourScale(ColourMap.FREEDOM, 0, 100, ColourField.ACCESS.unit()));
    }
}
