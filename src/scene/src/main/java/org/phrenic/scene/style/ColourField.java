package org.phrenic.scene.style;

/** A quantity that is shown in colours on a surface. */
public enum ColourField {
    NONE("", ""),
    /** Distance of each vertex from its rest position. */
    DISPLACEMENT("Displacement", "mm"),
    /** Change of area against rest, mean of the triangles about a vertex: 100 (A / A0 - 1). */
    STRAIN("Change of area", "%"),
    /** Distance to another surface, set in the renderer. */
    DISTANCE("Distance", "mm"),
    /** Share of a breath in which a path from a point of the skin is free, set in the renderer. */
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
