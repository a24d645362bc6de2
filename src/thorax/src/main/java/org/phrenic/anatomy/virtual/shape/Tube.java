package org.phrenic.anatomy.virtual.shape;

import java.util.function.DoubleFunction;
import java.util.function.UnaryOperator;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * A closed tube around a curve with superelliptic sections {@code |u/width|^n + |v/thickness|^n = 1}. Both ends are
 * rounded and coincide with the ends of the curve.
 *
 * @param around number of points of a section
 * @param along number of sections between the rounded ends
 * @param exponent n: 2 for an ellipse, larger for a flatter bar
 * @param capMm length of each rounded end
 */
public record Tube(int around, int along, double exponent, double capMm) {
    /** Number of sections of one rounded end, without its pole. */
    private static final int CAP_SECTIONS = 2;

    /** Half-width and half-thickness of a section, mm. */
    public record Section(double halfWidth, double halfThickness) {}

    public int vertexCount() {
        return around * (along + 2 * CAP_SECTIONS) + 2;
    }

    /**
     * @param sections section at a fraction 0-1 of the curve
     * @param outward direction of the section's thickness at a point of the curve
     */
    public TriangleMesh mesh(Polyline course, DoubleFunction<Section> sections, UnaryOperator<double[]> outward) {
        int rings = along + 2 * CAP_SECTIONS;
        double[] positions = new double[3 * vertexCount()];
        double length = course.length();
        double cap = Math.min(capMm, length / 3);
        for (int ring = 0; ring < rings; ring++) {
            double path;
            double scale = 1;
            if (ring < CAP_SECTIONS) {
                double angle = Math.PI / 2 * (ring + 1) / (CAP_SECTIONS + 1);
                path = cap * (1 - StrictMath.cos(angle));
                scale = StrictMath.sin(angle);
            } else if (ring >= rings - CAP_SECTIONS) {
                double angle = Math.PI / 2 * (rings - ring) / (CAP_SECTIONS + 1);
                path = length - cap * (1 - StrictMath.cos(angle));
                scale = StrictMath.sin(angle);
            } else {
                path = cap + (length - 2 * cap) * (ring - CAP_SECTIONS) / (along - 1);
            }
            double[] centre = course.pointAt(path);
            double[] tangent = course.direction(path);
            double[] thick = Vectors.orthonormalize(outward.apply(centre), tangent);
            double[] wide = Vectors.cross(thick, tangent);
            Section section = sections.apply(path / length);
            for (int k = 0; k < around; k++) {
                double angle = 2 * Math.PI * k / around;
                double u = power(StrictMath.cos(angle)) * section.halfWidth() * scale;
                double v = power(StrictMath.sin(angle)) * section.halfThickness() * scale;
                store(positions, ring * around + k, Vectors.addScaled(Vectors.addScaled(centre, wide, u), thick, v));
            }
        }
        store(positions, rings * around, course.first());
        store(positions, rings * around + 1, course.last());
        return new TriangleMesh(positions, triangles(rings));
    }

    private double power(double value) {
        return Math.signum(value) * StrictMath.pow(Math.abs(value), 2 / exponent);
    }

    private static void store(double[] positions, int vertex, double[] p) {
        System.arraycopy(p, 0, positions, 3 * vertex, 3);
    }

    private int[] triangles(int rings) {
        int[] triangles = new int[3 * (2 * around * (rings - 1) + 2 * around)];
        int n = 0;
        int last = (rings - 1) * around;
        for (int k = 0; k < around; k++) {
            int next = (k + 1) % around;
            n = triangle(triangles, n, rings * around, next, k);
            n = triangle(triangles, n, rings * around + 1, last + k, last + next);
            for (int ring = 0; ring < rings - 1; ring++) {
                int a = ring * around + k;
                int b = ring * around + next;
                n = triangle(triangles, n, a, b, b + around);
                n = triangle(triangles, n, a, b + around, a + around);
            }
        }
        return triangles;
    }

    private static int triangle(int[] triangles, int at, int a, int b, int c) {
        triangles[at] = a;
        triangles[at + 1] = b;
        triangles[at + 2] = c;
        return at + 3;
    }
}
