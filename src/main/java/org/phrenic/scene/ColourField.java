package org.phrenic.scene;

/** A quantity that is shown in colours on a surface. */
public enum ColourField {
    NONE(""),
    /** Distance of each vertex from where it rests. */
    DISPLACEMENT("mm"),
    /** Change of area against rest, mean of the triangles about a vertex: 100 (A / A0 - 1). */
    STRAIN("%"),
    /** Values given by {@link Renderer#setField}: the distance to another surface, say. */
    DISTANCE("mm");

    private final String unit;

    ColourField(String unit) {
        this.unit = unit;
    }

    public String unit() {
        return unit;
    }
}
