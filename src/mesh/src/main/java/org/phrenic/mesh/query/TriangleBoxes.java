package org.phrenic.mesh.query;

import java.util.Arrays;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * A bounding volume hierarchy of axis-aligned boxes over the triangles of a mesh. Nodes are split at the median
 * centroid along their longest axis, down to four triangles. They are stored in flat arrays, with the left child
 * directly after its parent. Corners are copied in leaf order for sequential memory access.
 */
abstract class TriangleBoxes {
    private static final int LEAF_TRIANGLES = 4;
    private static final int LEAF = -1;

    private final TriangleMesh mesh;
    /** Triangle indices in leaf order. */
    final int[] order;
    /** Nine corner coordinates per triangle, in leaf order. */
    final double[] corners;
    /** Unit normal per triangle, in leaf order. */
    final double[] normals;
    /** Whether a triangle is degenerate, in leaf order. */
    final boolean[] flat;

    final TriangleDiscs discs;
    /** Six numbers per node: minimum, then maximum. */
    final double[] boxes;
    /** Right child of an inner node; {@link #LEAF} for a leaf. */
    final int[] child;
    /** Number of triangles in the subtree of the node. */
    final int[] count;
    /** First leaf-order index in the subtree of the node. */
    final int[] first;

    int nodes;

    /** Place of each triangle in leaf order; null until it is needed. */
    private volatile int[] places;

    /** Whether normals, discs and degenerate triangles are those of the corners. */
    private volatile boolean measured;

    private final double[] normal = new double[3];

    TriangleBoxes(TriangleMesh mesh) {
        this.mesh = mesh;
        int n = mesh.triangleCount();
        order = new int[n];
        Arrays.setAll(order, i -> i);
        // Median splits leave each leaf at least half full.
        int most = Math.max(1, 4 * n / LEAF_TRIANGLES + 2);
        child = new int[most];
        count = new int[most];
        first = new int[most];
        if (n > 0) {
            build(0, n, centroids(mesh), new double[n]);
        }
        boxes = new double[6 * nodes];
        corners = new double[9 * n];
        normals = new double[3 * n];
        flat = new boolean[n];
        discs = new TriangleDiscs(n);
        refit(mesh.positions());
    }

    /** Three times the centroid of each triangle. */
    private static double[] centroids(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        double[] centroids = new double[t.length];
        for (int i = 0; i < t.length; i++) {
            int first = i - i % 3;
            int axis = i % 3;
            centroids[i] = p[3 * t[first] + axis] + p[3 * t[first + 1] + axis] + p[3 * t[first + 2] + axis];
        }
        return centroids;
    }

    public TriangleMesh mesh() {
        return mesh;
    }

    /** Place of a triangle in leaf order. */
    final int placeOf(int triangle) {
        if (places == null) {
            int[] inverse = new int[order.length];
            for (int place = 0; place < inverse.length; place++) {
                inverse[order[place]] = place;
            }
            places = inverse;
        }
        return places[triangle];
    }

    /** Moves the vertices and updates the boxes in one pass; the tree structure remains. */
    public void refit(double[] positions) {
        if (positions.length != 3 * mesh.vertexCount()) {
            throw new IllegalArgumentException(
                    "positions: " + positions.length + " numbers, expected " + 3 * mesh.vertexCount());
        }
        int[] t = mesh.triangles();
        for (int place = 0; place < order.length; place++) {
            int o = 9 * place;
            int corner = 3 * order[place];
            for (int k = 0; k < 9; k += 3) {
                int v = 3 * t[corner++];
                corners[o + k] = positions[v];
                corners[o + k + 1] = positions[v + 1];
                corners[o + k + 2] = positions[v + 2];
            }
        }
        measured = false;
        for (int node = nodes - 1; node >= 0; node--) {
            if (child[node] == LEAF) {
                boxOfLeaf(node);
            } else {
                for (int axis = 0; axis < 3; axis++) {
                    boxOfChildren(node, axis);
                }
            }
        }
    }

    /** Measures normals and discs for the first query of points since the vertices have moved; rays need none. */
    final void measure() {
        if (!measured) {
            measureTriangles();
        }
    }

    private synchronized void measureTriangles() {
        if (measured) {
            return;
        }
        for (int place = 0; place < order.length; place++) {
            int o = 9 * place;
            double length = Triangles.cross(corners, o, o + 3, o + 6, normal);
            double scale = length > 0 ? 1 / length : 0;
            normals[3 * place] = normal[0] * scale;
            normals[3 * place + 1] = normal[1] * scale;
            normals[3 * place + 2] = normal[2] * scale;
            flat[place] = PointTriangleDistance.isDegenerate(corners, o, normal);
            discs.fit(place, corners, o, normals, length);
        }
        measured = true;
    }

    private void boxOfLeaf(int node) {
        int from = 9 * first[node];
        BoundingBoxes.around(corners, from, from + 9 * count[node], boxes, 6 * node);
    }

    private void boxOfChildren(int node, int axis) {
        int box = 6 * node + axis;
        int left = box + 6;
        int right = 6 * child[node] + axis;
        boxes[box] = boxes[right] < boxes[left] ? boxes[right] : boxes[left];
        boxes[box + 3] = boxes[right + 3] > boxes[left + 3] ? boxes[right + 3] : boxes[left + 3];
    }

    private void build(int from, int to, double[] centroids, double[] keys) {
        int node = nodes++;
        count[node] = to - from;
        first[node] = from;
        if (to - from <= LEAF_TRIANGLES) {
            child[node] = LEAF;
            return;
        }
        int middle = (from + to) >>> 1;
        int axis = longestAxis(from, to, centroids);
        for (int i = from; i < to; i++) {
            keys[i] = centroids[3 * order[i] + axis];
        }
        select(from, to - 1, middle, keys);
        build(from, middle, centroids, keys);
        child[node] = nodes;
        build(middle, to, centroids, keys);
    }

    private int longestAxis(int from, int to, double[] centroids) {
        int longest = 0;
        double extent = -1;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                double value = centroids[3 * order[i] + axis];
                low = value < low ? value : low;
                high = value > high ? value : high;
            }
            if (high - low > extent) {
                extent = high - low;
                longest = axis;
            }
        }
        return longest;
    }

    /**
     * Quickselect with Hoare partitioning of triangles by their keys. Afterwards no key before {@code k} is greater
     * than one from {@code k} on.
     */
    private void select(int first, int last, int k, double[] keys) {
        int from = first;
        int to = last;
        while (from < to) {
            double pivot = medianOfThree(keys[from], keys[(from + to) >>> 1], keys[to]);
            int i = from;
            int j = to;
            while (i <= j) {
                while (keys[i] < pivot) {
                    i++;
                }
                while (keys[j] > pivot) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--, keys);
                }
            }
            if (k <= j) {
                to = j;
            } else if (k >= i) {
                from = i;
            } else {
                return;
            }
        }
    }

    private void swap(int i, int j, double[] keys) {
        int triangle = order[i];
        order[i] = order[j];
        order[j] = triangle;
        double key = keys[i];
        keys[i] = keys[j];
        keys[j] = key;
    }

    private static double medianOfThree(double a, double b, double c) {
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }
}
