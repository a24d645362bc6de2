package org.phrenic.scene.style;

/** A quantity shown in colours on a surface. */
public enum ColourField {
    NONE("", ""),
    /** Distance of each vertex from its rest position. */
    DISPLACEMENT("Displacement", "mm"),
    /** Change of area relative to rest: 100 (A / A0 - 1), where A is the total area of the triangles at a vertex. */
    STRAIN("Change of area", "%"),
    /** Distance to another surface; the renderer receives the values from outside. */
    DISTANCE("Distance", "mm"),
    /**
     * Percentage of a breath in which the path from a skin point is free; the renderer receives the values from
     * outside.
     */
    ACCESS("Free path", "% of a breath");

    private final String label;
    private final String unit;

    ColourField(String label, String unit) {
        this.label = label;
        this.unit = unit;
    }

    /** Display name; empty for none. */
    public String label() {
        return label;
    }

    public String unit() {
        return unit;
    }
}
