package org.phrenic.study.fit;

import java.util.Arrays;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.TriangleMesh;

/** The base of a lung by its shape alone, so that it is the same of a model and of a scan: the largest connected piece whose triangles look down. */
final class LookingDown {
    /** Upward part of the normal of a triangle that looks down, at most: steeper than 70 degrees is flank. */
    private static final double STEEPEST = -0.35;

    private LookingDown() {}

    /**
     * For each vertex whether it is of the base.
     *
     * @param mesh oriented outward
     */
    static boolean[] of(TriangleMesh mesh) {
        double[] normals = MeshMeasure.triangleNormals(mesh);
        int[] t = mesh.triangles();
        int[] root = new int[mesh.vertexCount()];
        Arrays.setAll(root, i -> i);
        boolean[] down = new boolean[mesh.triangleCount()];
        double outward = MeshMeasure.signedVolume(mesh) < 0 ? -1 : 1;
        for (int i = 0; i < down.length; i++) {
            double nx = normals[3 * i];
            double ny = normals[3 * i + 1];
            double nz = normals[3 * i + 2];
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            down[i] = length > 0 && outward * nz < STEEPEST * length;
            if (down[i]) {
                join(root, t[3 * i], t[3 * i + 1]);
                join(root, t[3 * i], t[3 * i + 2]);
            }
        }
        double[] area = new double[root.length];
        boolean[] used = new boolean[root.length];
        double[] areas = MeshMeasure.vertexAreas(mesh);
        for (int i = 0; i < down.length; i++) {
            for (int c = 3 * i; down[i] && c < 3 * i + 3; c++) {
                if (!used[t[c]]) {
                    used[t[c]] = true;
                    area[find(root, t[c])] += areas[t[c]];
                }
            }
        }
        int largest = 0;
        for (int i = 1; i < area.length; i++) {
            largest = area[i] > area[largest] ? i : largest;
        }
        boolean[] base = new boolean[root.length];
        for (int v = 0; v < base.length; v++) {
            base[v] = used[v] && find(root, v) == largest;
        }
        return base;
    }

    private static int find(int[] root, int vertex) {
        int v = vertex;
        while (root[v] != v) {
            root[v] = root[root[v]];
            v = root[v];
        }
        return v;
    }

    private static void join(int[] root, int a, int b) {
        int p = find(root, a);
        int q = find(root, b);
        root[Math.max(p, q)] = Math.min(p, q);
    }
}
