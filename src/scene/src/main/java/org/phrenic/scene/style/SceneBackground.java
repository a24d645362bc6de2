package org.phrenic.scene.style;

/** The background: a gradient, lighter in the middle. */
public enum SceneBackground {
    LIGHT(0xfbfaf7, 0xd5dae0),
    DARK(0x38404a, 0x14181d);

    private final int centreRgb;
    private final int edgeRgb;

    SceneBackground(int middle, int edge) {
        this.centreRgb = middle;
        this.edgeRgb = edge;
    }

    /** Colour in the middle of the picture, {@code 0xRRGGBB}. */
    public int centreRgb() {
        return centreRgb;
    }

    /** Colour towards the corners, {@code 0xRRGGBB}. */
    public int edgeRgb() {
        return edgeRgb;
    }
}
