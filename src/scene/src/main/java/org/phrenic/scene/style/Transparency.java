package org.phrenic.scene.style;

/** How translucent surfaces are blended. */
public enum Transparency {
    /** Back faces from the outside in, then front faces from the inside out: correct for nested shells, and fast. */
    TWO_PASS,
    /** Depth peeling: the four nearest layers of each pixel in their true order; slower. */
    PEELED
}
