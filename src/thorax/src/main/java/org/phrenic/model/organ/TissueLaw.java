package org.phrenic.model.organ;

import java.util.Arrays;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * How soft tissue becomes springs and masses: by the physical preset or by the paper's numbers.
 *
 * <p>Physical: a membrane of stiffness E h gives each of its triangles' edges √3/4 E h (Lloyd, Székely and Harders
 * 2007, doi 10.1109/TVCG.2007.1055, exact for equilateral triangles, ν = 1/3), and a node the area density times its
 * area, so motion does not depend on the resolution. Paper: one stiffness and one mass for all.
 */
public interface TissueLaw {

    /**
     * Stiffness of an edge between {@code triangles} triangles of a tissue, N/m.
     *
     * @param relative stiffness of the tissue as a multiple of relaxed muscle's
     */
    double edgeStiffness(int triangles, double relative);

    /**
     * Masses of the vertices of a surface, kg; a tissue of another stiffness is as much heavier, so that all tissue has
     * one wave speed.
     */
    double[] masses(TriangleMesh mesh, double relative);

    /**
     * What a bed that holds a surface's vertices to their places is multiplied by at each: in the physical preset its
     * area over {@value #BEDDING_AREA_MM2} mm², so that a bed's stiffness a unit of area is the same however fine the
     * mesh is; 1 in the paper's.
     */
    double[] beddingFactors(TriangleMesh mesh);

    /**
     * Where a vertex has this area, a bed's stiffness is what it is said to be: mean area of a node of the virtual
     * man's lungs at medium resolution.
     */
    double BEDDING_AREA_MM2 = 40;

    /** The physical preset; a sheet's stiffness is shared by its two faces. */
    static TissueLaw membrane(double sheetStiffness, double areaDensity) {
        return new TissueLaw() {
            @Override
            public double edgeStiffness(int triangles, double relative) {
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

            /** Areas of the vertices, times a factor. */
            private double[] areas(TriangleMesh mesh, double factor) {
                double[] areas = MeshMeasure.vertexAreas(mesh);
                double least = 0.1 * MeshMeasure.area(mesh) / areas.length;
                for (int i = 0; i < areas.length; i++) {
                    // A sliver's vertex has next to no area; it gets a tenth of the mean, or it would set the step for
                    // all.
                    areas[i] = Math.max(areas[i], least) * factor;
                }
                return areas;
            }
        };
    }

    /** The paper's one stiffness and one mass. */
    static TissueLaw uniform(double stiffness, double mass) {
        return new TissueLaw() {
            @Override
            public double edgeStiffness(int triangles, double relative) {
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

    /** Springs along all edges of a passive surface, at its present lengths. */
    default void addEdges(SpringList springs, TriangleMesh mesh, int first, double relative) {
        EdgeTable table = new EdgeTable(mesh);
        int[] edges = table.edges();
        double[] p = mesh.positions();
        for (int e = 0; e < table.edgeCount(); e++) {
            int a = edges[2 * e];
            int b = edges[2 * e + 1];
            int triangles = Math.min(table.faceCount(e), 2);
            springs.add(
                    first + a,
                    first + b,
                    edgeStiffness(triangles, relative),
                    MassSpringBuilder.distance(p, a, p, b),
                    0);
        }
    }
}
