package org.phrenic.mesh;

import java.util.stream.IntStream;

/**
 * Closed surfaces through a stack of rings that have equally many vertices. A fan of triangles about a pole closes each
 * end. Vertices are those of the rings, ring by ring, then the pole of the first ring, then that of the last.
 */
public final class RingStack {
    private RingStack() {}

    /**
     * Mesh through given vertices. Its normals point outward if a ring runs counterclockwise seen from the last pole.
     *
     * @param positions x, y, z of every vertex in the order of the class, mm
     * @param segments vertices of a ring
     */
    public static TriangleMesh mesh(double[] positions, int segments) {
        int first = positions.length / 3 - 2;
        int top = first - segments;
        IntStream.Builder triangles = IntStream.builder();
        for (int k = 0; k < segments; k++) {
            int next = (k + 1) % segments;
            triangles.add(first).add(next).add(k);
            triangles.add(first + 1).add(top + k).add(top + next);
            for (int r = 0; r < top; r += segments) {
                triangles.add(r + k).add(r + next).add(r + segments + next);
                triangles.add(r + k).add(r + segments + next).add(r + segments + k);
            }
        }
        return new TriangleMesh(positions, triangles.build().toArray());
    }

    /**
     * Surface of revolution about the z axis, closed at both ends.
     *
     * @param start z of the first pole, mm
     * @param end z of the last pole, mm
     * @param profile pairs of z and radius of the rings, mm, z ascending
     */
    public static TriangleMesh revolution(int segments, double start, double end, double... profile) {
        int poles = profile.length / 2 * segments;
        double[] p = new double[3 * (poles + 2)];
        for (int v = 0; v < poles; v++) {
            int ring = v / segments;
            double angle = 2 * Math.PI * (v % segments) / segments;
            p[3 * v] = profile[2 * ring + 1] * StrictMath.cos(angle);
            p[3 * v + 1] = profile[2 * ring + 1] * StrictMath.sin(angle);
            p[3 * v + 2] = profile[2 * ring];
        }
        p[3 * poles + 2] = start;
        p[3 * poles + 5] = end;
        return mesh(p, segments);
    }

    /** Ball of radius 1 about the origin, of circles of latitude at equal angles; {@code segments} is even. */
    public static TriangleMesh unitBall(int segments) {
        int rings = segments / 2;
        double[] profile = new double[2 * (rings - 1)];
        for (int i = 1; i < rings; i++) {
            profile[2 * i - 2] = -StrictMath.cos(Math.PI * i / rings);
            profile[2 * i - 1] = StrictMath.sin(Math.PI * i / rings);
        }
        return revolution(segments, -1, 1, profile);
    }
}
