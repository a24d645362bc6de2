package org.phrenic.scene.style;

import org.phrenic.scene.gl.Renderer;

/** A quantity that is shown in colours on a surface. */
public enum ColourField {
    NONE("", ""),
    /** Distance of each vertex from where it rests. */
    DISPLACEMENT("Displacement", "mm"),
    /** Change of area against rest, mean of the triangles about a vertex: 100 (A / A0 - 1). */
    STRAIN("Change of area", "%"),
    /** Values given by {@link Renderer#setField}: the distance to another surface, say. */
    DISTANCE("Distance", "mm"),
    /** Values given by {@link Renderer#setField}: in how much of a breath a path from a point of the skin is free. */
    ACCESS("Free path", "% of a breath");

    private final String label;
    private final String unit;

    ColourField(String label, String unit) {
        this.label = label;
        this.unit = unit;
    }

    /** Name for people; empty for none. */
    public String label() {
        return label;
    }

    public String unit() {
        return unit;
    }
}
