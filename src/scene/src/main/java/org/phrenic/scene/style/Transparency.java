package org.phrenic.scene.style;

/** Method of blending translucent surfaces. */
public enum Transparency {
    /**
     * Back faces from the outermost to the innermost surface, then front faces in reverse order. Fast, and correct for
     * nested closed surfaces.
     */
    TWO_PASS,
    /** Depth peeling: the four nearest layers of each pixel in depth order. Slower. */
    PEELED
}
