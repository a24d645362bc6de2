package org.phrenic.anatomy;

/**
 * Mesh resolution of the deformable parts. The totals are the vertex counts of table 1 of Villard, Bourne and Bello
 * 2009. The paper does not say which vertices it counts; here they are those of the diaphragm, cartilages, sternum and
 * lungs. Vertices of rigid parts are not included.
 */
public enum Resolution {
    LOW(12_047),
    MEDIUM(16_023),
    HIGH(20_909);

    /** Fraction of vertices on the diaphragm: the paper's generic diaphragm has 11,359 of 20,909 nodes of its scene. */
    private static final double DIAPHRAGM_SHARE = 11_359.0 / 20_909.0;

    private static final double LUNG_SHARE = 0.30;

    private final int vertices;

    Resolution(int vertices) {
        this.vertices = vertices;
    }

    /** Total number of vertices of deformable parts. */
    public int vertices() {
        return vertices;
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
