package org.phrenic.scene;

/** What is behind the body: a soft gradient, lighter in the middle. */
public enum Background {
    LIGHT(0xfbfaf7, 0xd5dae0),
    DARK(0x38404a, 0x14181d);

    private final int middle;
    private final int edge;

    Background(int middle, int edge) {
        this.middle = middle;
        this.edge = edge;
    }

    /** Colour in the middle of the picture, {@code 0xRRGGBB}. */
    public int middle() {
        return middle;
    }

    /** Colour towards the corners, {@code 0xRRGGBB}. */
    public int edge() {
        return edge;
    }
}
