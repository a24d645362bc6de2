package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntFunction;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * Improves triangle quality on a given surface. A sweep flips edges towards Delaunay, moves each vertex towards the
 * mean of its neighbours and projects it back on its surface. The numbers of vertices and triangles do not change.
 */
public final class SurfaceRelaxation {
    /** Relaxation factor: fraction of the way to the mean of the neighbours in one sweep. */
    private static final double STEP = 0.7;
    /** Ends of edges shorter than this fraction of the mean edge repel each other. */
    private static final double REPULSION_EDGE_SHARE = 0.65;

    private static final double REPULSION = 2.0;
    private static final double MAX_PUSH = 1.5;
    /** Shortest edge as a fraction of the mean edge. */
    private static final double MIN_EDGE_SHARE = 0.5;

    private static final int MAX_LENGTHENING_PASSES = 30;

    private final double[] positions;
    private final int[] triangles;
    private final IntFunction<ImplicitSurface> surface;
    private final double meanEdge;
    private final double[] first = new double[3];
    private final double[] second = new double[3];
    private final double[] third = new double[3];
    private final double[] fourth = new double[3];

    private SurfaceRelaxation(TriangleMesh mesh, IntFunction<ImplicitSurface> surface) {
        positions = mesh.positions().clone();
        triangles = mesh.triangles().clone();
        this.surface = surface;
        meanEdge = meanEdge(positions, triangles);
    }

    /** @param surface surface of each vertex; null for a fixed vertex */
    public static TriangleMesh relax(TriangleMesh mesh, int sweeps, IntFunction<ImplicitSurface> surface) {
        SurfaceRelaxation relaxation = new SurfaceRelaxation(mesh, surface);
        for (int i = 0; i < sweeps; i++) {
            relaxation.flip();
            relaxation.smooth(i == sweeps - 1 ? 4 : 1);
        }
        relaxation.flip();
        return new TriangleMesh(relaxation.positions, relaxation.triangles);
    }

    /**
     * Relaxes as {@link #relax}, then lengthens edges shorter than a fraction of the mean edge. The shortest edge
     * limits the time step of a simulation on the mesh.
     */
    public static TriangleMesh relaxAndLengthen(TriangleMesh mesh, int sweeps, IntFunction<ImplicitSurface> surface) {
        SurfaceRelaxation relaxation = new SurfaceRelaxation(relax(mesh, sweeps, surface), surface);
        for (int i = 0; i < MAX_LENGTHENING_PASSES && relaxation.separateShortEdges(); i++) {
            relaxation.flip();
        }
        return new TriangleMesh(relaxation.positions, relaxation.triangles);
    }

    /** Moves both ends of each short edge apart by half its deficit and projects them; false if no edge was short. */
    private boolean separateShortEdges() {
        double least = MIN_EDGE_SHARE * meanEdge;
        double[] move = new double[positions.length];
        boolean[] moved = new boolean[positions.length / 3];
        boolean any = false;
        for (int c = 0; c < triangles.length; c++) {
            int a = triangles[c];
            int b = triangles[next(c)];
            double[] way = Vectors.subtract(vertex(b), vertex(a));
            double length = Math.max(Vectors.length(way), 1e-9);
            if (length < least && (surface.apply(a) != null || surface.apply(b) != null)) {
                any = true;
                moved[a] = true;
                for (int axis = 0; axis < 3; axis++) {
                    move[3 * a + axis] -= (least / length - 1) / 2 * way[axis];
                }
            }
        }
        for (int v = 0; v < moved.length; v++) {
            ImplicitSurface field = surface.apply(v);
            if (moved[v] && field != null) {
                double[] way = Vectors.of(move[3 * v], move[3 * v + 1], move[3 * v + 2]);
                System.arraycopy(field.project(Vectors.addScaled(vertex(v), way, 1), 4), 0, positions, 3 * v, 3);
            }
        }
        return any;
    }

    private double[] vertex(int v) {
        return Vectors.of(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    }

    private void smooth(int steps) {
        int n = positions.length / 3;
        double[] sum = new double[positions.length];
        int[] count = new int[n];
        for (int t = 0; t < triangles.length; t += 3) {
            for (int k = 0; k < 3; k++) {
                int a = triangles[t + k];
                int b = triangles[t + (k + 1) % 3];
                accumulateMove(a, b, sum);
                count[a]++;
            }
        }
        for (int v = 0; v < n; v++) {
            ImplicitSurface field = surface.apply(v);
            if (field == null) {
                continue;
            }
            double[] move = Vectors.of(sum[3 * v], sum[3 * v + 1], sum[3 * v + 2]);
            double[] moved = Vectors.addScaled(vertex(v), move, STEP / count[v]);
            System.arraycopy(field.project(moved, steps), 0, positions, 3 * v, 3);
        }
    }

    /** Adds to the displacement of vertex a: towards its neighbour b, or away from it if they are too close. */
    private void accumulateMove(int a, int b, double[] sum) {
        double x = positions[3 * b] - positions[3 * a];
        double y = positions[3 * b + 1] - positions[3 * a + 1];
        double z = positions[3 * b + 2] - positions[3 * a + 2];
        double length = Math.max(Math.sqrt(x * x + y * y + z * z), 1e-9);
        double least = REPULSION_EDGE_SHARE * meanEdge;
        double weight = length < least ? 1 - REPULSION * (least / length - 1) : 1;
        weight = Math.max(weight, -MAX_PUSH * least / length);
        sum[3 * a] += weight * x;
        sum[3 * a + 1] += weight * y;
        sum[3 * a + 2] += weight * z;
    }

    private static double meanEdge(double[] positions, int[] triangles) {
        double sum = 0;
        for (int c = 0; c < triangles.length; c++) {
            int a = 3 * triangles[c];
            int b = 3 * triangles[next(c)];
            double dx = positions[a] - positions[b];
            double dy = positions[a + 1] - positions[b + 1];
            double dz = positions[a + 2] - positions[b + 2];
            sum += Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        return sum / triangles.length;
    }

    /**
     * Flips every inner edge whose opposite angles sum to more than 180 degrees; each triangle changes at most once.
     */
    private void flip() {
        int corners = triangles.length;
        long[] edges = sortedEdges();
        boolean[] touched = new boolean[corners / 3];
        Set<Long> made = new HashSet<>();
        for (int i = 0; i + 1 < corners; i++) {
            if (edges[i] >>> 21 != edges[i + 1] >>> 21) {
                continue;
            }
            int c = (int) (edges[i] & 0x1FFFFF);
            int d = (int) (edges[i + 1] & 0x1FFFFF);
            if (!touched[c / 3]
                    && !touched[d / 3]
                    && violatesDelaunay(c, d)
                    && isNewEdge(edges, c, d)
                    && made.add(flippedEdge(c, d))) {
                int a = triangles[c];
                int b = triangles[next(c)];
                int p = triangles[next(next(c))];
                int q = triangles[next(next(d))];
                setTriangle(c / 3, a, q, p);
                setTriangle(d / 3, q, b, p);
                touched[c / 3] = true;
                touched[d / 3] = true;
            }
        }
    }

    /**
     * Edge of every triangle corner, packed as (lower vertex, higher vertex, corner) in ascending order. A bucket sort
     * by lower vertex is followed by a sort of each short bucket.
     */
    private long[] sortedEdges() {
        int corners = triangles.length;
        int[] start = new int[positions.length / 3 + 1];
        for (int c = 0; c < corners; c++) {
            start[Math.min(triangles[c], triangles[next(c)]) + 1]++;
        }
        for (int v = 1; v < start.length; v++) {
            start[v] += start[v - 1];
        }
        long[] edges = new long[corners];
        for (int c = 0; c < corners; c++) {
            long low = Math.min(triangles[c], triangles[next(c)]);
            long high = Math.max(triangles[c], triangles[next(c)]);
            edges[start[(int) low]++] = (low << 42) | (high << 21) | c;
        }
        // The scatter has advanced each bucket's start to its end.
        for (int v = 0, from = 0; v < start.length - 1; from = start[v++]) {
            RadixSort.sort(edges, from, start[v]);
        }
        return edges;
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    private void setTriangle(int triangle, int a, int b, int c) {
        triangles[3 * triangle] = a;
        triangles[3 * triangle + 1] = b;
        triangles[3 * triangle + 2] = c;
    }

    /** Edge that a flip would create, packed as in the upper bits of a sorted edge. */
    private long flippedEdge(int c, int d) {
        long p = triangles[next(next(c))];
        long q = triangles[next(next(d))];
        return (Math.min(p, q) << 42) | (Math.max(p, q) << 21);
    }

    /** True if the edge that a flip would create does not exist. */
    private boolean isNewEdge(long[] edges, int c, int d) {
        long key = flippedEdge(c, d);
        int at = Arrays.binarySearch(edges, key);
        int from = at >= 0 ? at : -at - 1;
        return from >= edges.length || edges[from] >>> 21 != key >>> 21;
    }

    private boolean violatesDelaunay(int c, int d) {
        int a = triangles[c];
        int b = triangles[next(c)];
        int p = triangles[next(next(c))];
        int q = triangles[next(next(d))];
        if (cotangent(p, a, b) + cotangent(q, a, b) >= -1e-9) {
            return false;
        }
        cross(a, b, p, first);
        cross(b, a, q, second);
        if (Vectors.dot(first, second) < 0.7 * Vectors.length(first) * Vectors.length(second)) {
            return false;
        }
        cross(a, q, p, third);
        cross(q, b, p, fourth);
        return Vectors.dot(third, first) > 0
                && Vectors.dot(third, second) > 0
                && Vectors.dot(fourth, first) > 0
                && Vectors.dot(fourth, second) > 0;
    }

    /** Twice the area vector of the triangle (o, a, b). */
    private void cross(int o, int a, int b, double[] into) {
        Triangles.cross(positions, 3 * o, 3 * a, 3 * b, into);
    }

    private double cotangent(int apex, int a, int b) {
        double ux = positions[3 * a] - positions[3 * apex];
        double uy = positions[3 * a + 1] - positions[3 * apex + 1];
        double uz = positions[3 * a + 2] - positions[3 * apex + 2];
        double vx = positions[3 * b] - positions[3 * apex];
        double vy = positions[3 * b + 1] - positions[3 * apex + 1];
        double vz = positions[3 * b + 2] - positions[3 * apex + 2];
        double x = uy * vz - uz * vy;
        double y = uz * vx - ux * vz;
        double z = ux * vy - uy * vx;
        return (ux * vx + uy * vy + uz * vz) / Math.max(Math.sqrt(x * x + y * y + z * z), 1e-12);
    }
}
