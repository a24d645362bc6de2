package org.phrenic.model.organ;

import java.util.Arrays;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Maps soft tissue to springs and masses, for the physical preset or the paper's model.
 *
 * <p>Physical: a membrane of stiffness E h gives each edge of its triangles √3/4 E h (Lloyd, Székely and Harders 2007,
 * doi 10.1109/TVCG.2007.1055; exact for equilateral triangles, ν = 1/3). The mass of a node is the area density times
 * its area, so motion does not depend on the resolution.
 *
 * <p>Paper: one stiffness for all springs and one mass for all nodes.
 */
public interface TissueLaw {

    /**
     * Stiffness of an edge shared by {@code triangles} triangles of a tissue, N/m. Between triangles that are not
     * equilateral an edge counts for √3 (cot α + cot β) triangles, α and β the opposite angles: 3/4 E h cot α for each.
     * Then Σ k l² (cos 2φ, sin 2φ) over the edges of a triangle, φ their directions, is 0, and a sheet of long
     * triangles is no stiffer along them than across.
     *
     * @param relative stiffness of the tissue as a multiple of relaxed muscle's
     */
    double edgeStiffness(double triangles, double relative);

    /**
     * Masses of the vertices of a surface, kg. Mass scales with the relative stiffness, so that all tissue has the same
     * wave speed.
     */
    double[] masses(TriangleMesh mesh, double relative);

    /**
     * Factor of the bedding stiffness at each vertex of a surface. In the physical preset it is the vertex area over
     * {@value #BEDDING_AREA_MM2} mm², so that the bedding stiffness per unit of area does not depend on the mesh. In
     * the paper's model it is 1.
     */
    double[] beddingFactors(TriangleMesh mesh);

    /**
     * Vertex area for which the bedding factor is 1: mean node area of the virtual man's lungs at medium resolution.
     */
    double BEDDING_AREA_MM2 = 40;

    /** The physical preset. The two faces of a sheet share its stiffness. */
    static TissueLaw membrane(double sheetStiffness, double areaDensity) {
        return new TissueLaw() {
            @Override
            public double edgeStiffness(double triangles, double relative) {
                return triangles * Math.sqrt(3) / 4 * relative * sheetStiffness / 2;
            }

            @Override
            public double[] masses(TriangleMesh mesh, double relative) {
                return areas(mesh, relative * areaDensity * 1e-6);
            }

            @Override
            public double[] beddingFactors(TriangleMesh mesh) {
                return areas(mesh, 1 / BEDDING_AREA_MM2);
            }

            /** Vertex areas times a factor, with a lower bound. */
            private double[] areas(TriangleMesh mesh, double factor) {
                double[] areas = MeshMeasure.vertexAreas(mesh);
                double least = 0.1 * MeshMeasure.area(mesh) / areas.length;
                for (int i = 0; i < areas.length; i++) {
                    // A vertex of slivers has almost no area. It gets at least a tenth of the mean area; otherwise it
                    // would set the time step of the whole scene.
                    areas[i] = Math.max(areas[i], least) * factor;
                }
                return areas;
            }
        };
    }

    /** The paper's model: uniform stiffness and uniform mass. */
    static TissueLaw uniform(double stiffness, double mass) {
        return new TissueLaw() {
            @Override
            public double edgeStiffness(double triangles, double relative) {
                return relative * stiffness;
            }

            @Override
            public double[] masses(TriangleMesh mesh, double relative) {
                return all(mesh, mass);
            }

            @Override
            public double[] beddingFactors(TriangleMesh mesh) {
                return all(mesh, 1);
            }

            private double[] all(TriangleMesh mesh, double value) {
                double[] out = new double[mesh.vertexCount()];
                Arrays.fill(out, value);
                return out;
            }
        };
    }

    /** Adds springs along all edges of a passive surface, with their current lengths as rest lengths. */
    default void addEdges(SpringList springs, TriangleMesh mesh, int first, double relative) {
        EdgeTable table = new EdgeTable(mesh);
        int[] edges = table.edges();
        double[] p = mesh.positions();
        for (int e = 0; e < table.edgeCount(); e++) {
            double stiffness = edgeStiffness(Math.min(table.faceCount(e), 2), relative);
            springs.addEdge(p, first, edges[2 * e], edges[2 * e + 1], stiffness, 0);
        }
    }
}
