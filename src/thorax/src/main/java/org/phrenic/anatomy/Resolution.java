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

    private final MeshBudget budget;

    Resolution(int vertices) {
        budget = new MeshBudget(vertices);
    }

    /** Numbers of vertices of the deformable parts. */
    public MeshBudget budget() {
        return budget;
    }

    /** Total number of vertices of deformable parts. */
    public int vertices() {
        return budget.vertices();
    }

    /** Number of vertices on the diaphragm (both faces). */
    public int diaphragmVertices() {
        return budget.diaphragmVertices();
    }
}
