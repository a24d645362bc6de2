package org.phrenic.mesh.query;

import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Sample points on surfaces with a maximum spacing: a regular barycentric grid on each triangle. Points on shared
 * corners and edges are repeated.
 */
public final class SurfaceSamples {
    private final double spacing;
    private final DoubleList points = new DoubleList();

    /**
     * @param spacing greatest distance between neighbouring points, mm
     * @throws IllegalArgumentException if it is not positive
     */
    public SurfaceSamples(double spacing) {
        if (!(spacing > 0)) {
            throw new IllegalArgumentException("spacing: found " + spacing + " mm, expected more than 0");
        }
        this.spacing = spacing;
    }

    /** Adds samples on a whole surface. */
    public void add(TriangleMesh mesh) {
        for (int t = 0; t < mesh.triangleCount(); t++) {
            add(mesh, t);
        }
    }

    /** Adds samples on one triangle of a surface. */
    public void add(TriangleMesh mesh, int triangle) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        int a = t[3 * triangle];
        int b = t[3 * triangle + 1];
        int c = t[3 * triangle + 2];
        double longest = Math.max(
                MeshMeasure.distance(mesh, a, b),
                Math.max(MeshMeasure.distance(mesh, b, c), MeshMeasure.distance(mesh, c, a)));
        int parts = Math.max(1, (int) Math.ceil(longest / spacing));
        for (int i = 0; i <= parts; i++) {
            for (int j = 0; i + j <= parts; j++) {
                double u = i / (double) parts;
                double v = j / (double) parts;
                for (int axis = 0; axis < 3; axis++) {
                    points.add((1 - u - v) * p[3 * a + axis] + u * p[3 * b + axis] + v * p[3 * c + axis]);
                }
            }
        }
    }

    /** A copy of all samples, three numbers each, mm. */
    public double[] points() {
        return points.toArray();
    }
}
