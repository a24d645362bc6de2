package org.phrenic.mesh.edit;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * Cuts a surface along the zero level of a function that is given at its vertices and linear on its edges (marching
 * triangles). A vertex near the level is moved along an edge onto it first, so that the border has no slivers.
 */
public final class LevelClip {
    /** A vertex is moved by up to this share of an edge. */
    private static final double SNAP = 0.25;

    private static final int VERTEX_BITS = 32;

    private final int[] triangles;
    private final double[] values;
    private final double[] snapped;
    private final DoubleList positions = new DoubleList();
    private final IntList kept = new IntList();
    private final Map<Long, Integer> crossings = new HashMap<>();

    private LevelClip(TriangleMesh mesh, double[] values) {
        triangles = mesh.triangles();
        this.values = values.clone();
        snapped = snap(mesh.positions(), triangles, this.values);
        for (double coordinate : snapped) {
            positions.add(coordinate);
        }
    }

    /**
     * The part of a surface where a function is positive.
     *
     * @param values the function at each vertex
     */
    public static TriangleMesh positivePart(TriangleMesh mesh, double[] values) {
        LevelClip clip = new LevelClip(mesh, values);
        for (int t = 0; t < clip.triangles.length; t += 3) {
            clip.cut(t);
        }
        int[] corners = clip.kept.toArray();
        boolean[] used = new boolean[clip.positions.size() / 3];
        for (int v : corners) {
            used[v] = true;
        }
        return MeshRepair.compact(clip.positions.toArray(), corners, used);
    }

    /** Moves vertices near the level onto it and sets their values to 0; returns the positions. */
    private static double[] snap(double[] from, int[] triangles, double[] values) {
        double[] positions = from.clone();
        double[] share = new double[values.length];
        Arrays.fill(share, SNAP);
        for (int c = 0; c < triangles.length; c++) {
            int a = triangles[c];
            int b = triangles[EdgeTable.next(c, 3)];
            if (values[a] * values[b] < 0) {
                double cut = values[a] / (values[a] - values[b]);
                move(a, b, cut, from, share, positions);
                move(b, a, 1 - cut, from, share, positions);
            }
        }
        for (int v = 0; v < values.length; v++) {
            values[v] = share[v] < SNAP ? 0 : values[v];
        }
        return positions;
    }

    /** Moves a vertex toward another unless it has moved a smaller share of an edge. */
    private static void move(int v, int toward, double cut, double[] from, double[] share, double[] positions) {
        if (cut < share[v]) {
            share[v] = cut;
            double[] p = Vectors.lerp(point(from, v), point(from, toward), cut);
            System.arraycopy(p, 0, positions, 3 * v, 3);
        }
    }

    private static double[] point(double[] positions, int v) {
        return Arrays.copyOfRange(positions, 3 * v, 3 * v + 3);
    }

    /** Adds the part of a triangle where the function is positive: a triangle, a quadrilateral or nothing. */
    private void cut(int t) {
        int[] polygon = new int[4];
        int count = 0;
        boolean positive = false;
        for (int i = 0; i < 3; i++) {
            int a = triangles[t + i];
            int b = triangles[EdgeTable.next(t + i, 3)];
            positive |= values[a] > 0;
            if (values[a] >= 0) {
                polygon[count++] = a;
            }
            if (values[a] * values[b] < 0) {
                polygon[count++] = crossing(a, b);
            }
        }
        if (!positive) {
            return;
        }
        if (count == 3) {
            add(polygon[0], polygon[1], polygon[2]);
        } else if (positions.squaredDistance(polygon[0], polygon[2])
                <= positions.squaredDistance(polygon[1], polygon[3])) {
            add(polygon[0], polygon[1], polygon[2]);
            add(polygon[0], polygon[2], polygon[3]);
        } else {
            add(polygon[0], polygon[1], polygon[3]);
            add(polygon[1], polygon[2], polygon[3]);
        }
    }

    private void add(int a, int b, int c) {
        kept.add(a);
        kept.add(b);
        kept.add(c);
    }

    /** The vertex where an edge crosses the level. */
    private int crossing(int a, int b) {
        int low = Math.min(a, b);
        int high = Math.max(a, b);
        return crossings.computeIfAbsent((long) low << VERTEX_BITS | high, key -> {
            double cut = values[low] / (values[low] - values[high]);
            double[] p = Vectors.lerp(point(snapped, low), point(snapped, high), cut);
            return positions.add(p[0], p[1], p[2]);
        });
    }
}
