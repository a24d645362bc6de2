package org.phrenic.mesh.edit;

import java.util.Arrays;

/**
 * The neighbours of a vertex v in cyclic order; at a boundary they run from one boundary edge to the other. The
 * triangles at v are (v, vertices[i], next(i)) for i below {@link #triangles}.
 */
final class OneRing {
    int vertex;
    int[] vertices = new int[64];
    int size;
    int triangles;

    void add(int v) {
        if (size == vertices.length) {
            vertices = Arrays.copyOf(vertices, 2 * size);
        }
        vertices[size++] = v;
    }

    int next(int i) {
        return vertices[i + 1 == size ? 0 : i + 1];
    }

    /** Whether the i-th triangle contains a vertex besides v. */
    boolean triangleHas(int i, int v) {
        return vertices[i] == v || next(i) == v;
    }

    boolean contains(int v) {
        for (int i = 0; i < size; i++) {
            if (vertices[i] == v) {
                return true;
            }
        }
        return false;
    }
}
