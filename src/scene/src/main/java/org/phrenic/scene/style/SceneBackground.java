package org.phrenic.scene.style;

/** Background gradient of a scene, lighter in the centre. */
public enum SceneBackground {
    LIGHT(0xfbfaf7, 0xd5dae0),
    DARK(0x38404a, 0x14181d);

    private final int centreRgb;
    private final int edgeRgb;

    SceneBackground(int middle, int edge) {
        this.centreRgb = middle;
        this.edgeRgb = edge;
    }

    /** Colour at the centre of the picture, {@code 0xRRGGBB}. */
    public int centreRgb() {
        return centreRgb;
    }

    /** Colour at the corners, {@code 0xRRGGBB}. */
    public int edgeRgb() {
        return edgeRgb;
    }
}
