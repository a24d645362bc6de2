package org.phrenic.scene.style;

/** How what can be seen through is put together. */
public enum Transparency {
    /**
     * Back faces from the outside in, then front faces from the inside out: right for shells within each other, and
     * cheap.
     */
    TWO_PASS,
    /** The four nearest layers of each pixel in their true order: for pictures that may take their time. */
    PEELED
}
