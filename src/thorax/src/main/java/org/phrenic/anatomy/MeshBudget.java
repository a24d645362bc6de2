package org.phrenic.anatomy;

/**
 * Number of vertices of the deformable parts, and how they are distributed. The mean edge length of a part is
 * proportional to one over the square root of its number of vertices.
 *
 * @param vertices total number of vertices of diaphragm, lungs, sternum and costal cartilages
 */
public record MeshBudget(int vertices) {
    /** Fraction of vertices on the diaphragm: the paper's generic diaphragm has 11,359 of 20,909 nodes of its scene. */
    private static final double DIAPHRAGM_SHARE = 11_359.0 / 20_909.0;

    private static final double LUNG_SHARE = 0.30;

    /** The smallest budget whose diaphragm has this many vertices. */
    public static MeshBudget ofDiaphragm(int vertices) {
        return new MeshBudget((int) Math.round(vertices / DIAPHRAGM_SHARE));
    }

    /** Number of vertices on the diaphragm (both faces). */
    public int diaphragmVertices() {
        return (int) Math.round(vertices * DIAPHRAGM_SHARE);
    }

    /** Number of vertices on both lungs. */
    public int lungVertices() {
        return (int) Math.round(vertices * LUNG_SHARE);
    }

    /** Number of vertices on sternum and costal cartilages. */
    public int sternumVertices() {
        return vertices - diaphragmVertices() - lungVertices();
    }
}
