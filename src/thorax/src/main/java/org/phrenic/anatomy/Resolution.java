package org.phrenic.anatomy;

/**
 * How finely the parts that springs move are meshed. The totals are the vertex counts of table 1 of Villard, Bourne and
 * Bello 2009; the paper does not say which vertices it counts, here they are all that springs move (diaphragm,
 * cartilages and sternum, lungs). Rigid parts come on top.
 */
public enum Resolution {
    LOW(12_047),
    MEDIUM(16_023),
    HIGH(20_909);

    /** The paper's generic diaphragm has 11,359 nodes in its scene of 20,909: the share of the sheet in the total. */
    private static final double DIAPHRAGM_SHARE = 11_359.0 / 20_909.0;

    private static final double LUNG_SHARE = 0.30;

    private final int vertices;

    Resolution(int vertices) {
        this.vertices = vertices;
    }

    /** Vertices moved by springs, in all. */
    public int vertices() {
        return vertices;
    }

    /** Of these, on the diaphragm (both faces). */
    public int diaphragmVertices() {
        return (int) Math.round(vertices * DIAPHRAGM_SHARE);
    }

    /** Of these, on the two lungs together. */
    public int lungVertices() {
        return (int) Math.round(vertices * LUNG_SHARE);
    }

    /** Of these, on sternum and costal cartilages together. */
    public int sternumVertices() {
        return vertices - diaphragmVertices() - lungVertices();
    }
}
