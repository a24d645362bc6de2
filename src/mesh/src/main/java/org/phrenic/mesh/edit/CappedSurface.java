package org.phrenic.mesh.edit;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;

/**
 * A surface whose holes are closed by cones: each component of the boundary gets an apex at the mean of its vertices
 * and a triangle from each boundary edge to it. Every ray then enters as often as it leaves.
 */
public final class CappedSurface {
    private final int[] triangles;
    private final int vertices;
    /** Vertices of the boundary below each apex. */
    private final int[][] rims;

    public CappedSurface(TriangleMesh mesh) {
        vertices = mesh.vertexCount();
        int[] edges = boundary(mesh.triangles());
        int[] components = DisjointSets.singletons(vertices);
        for (int i = 0; i < edges.length; i += 2) {
            DisjointSets.unionToLower(components, edges[i], edges[i + 1]);
        }
        Map<Integer, IntList> rim = new HashMap<>();
        IntList order = new IntList();
        for (int i = 0; i < edges.length; i += 2) {
            int root = DisjointSets.find(components, edges[i]);
            rim.computeIfAbsent(root, any -> {
                        order.add(root);
                        return new IntList();
                    })
                    .add(edges[i]);
        }
        rims = new int[order.size()][];
        Map<Integer, Integer> apex = new HashMap<>();
        for (int i = 0; i < rims.length; i++) {
            rims[i] = rim.get(order.get(i)).toArray();
            apex.put(order.get(i), vertices + i);
        }
        int[] t = mesh.triangles();
        triangles = Arrays.copyOf(t, t.length + edges.length / 2 * 3);
        for (int i = 0, at = t.length; i < edges.length; i += 2, at += 3) {
            triangles[at] = edges[i + 1];
            triangles[at + 1] = edges[i];
            triangles[at + 2] = apex.get(DisjointSets.find(components, edges[i]));
        }
    }

    /**
     * Directed edges that triangles pass more often than their reverse, as pairs of vertices, each as often as it
     * outnumbers it. They form closed loops, whether the surface is manifold or not.
     */
    private static int[] boundary(int[] t) {
        Map<Long, Integer> surplus = new HashMap<>();
        for (int i = 0; i < t.length; i++) {
            surplus.merge(key(t[i], next(t, i)), 1, Integer::sum);
            surplus.merge(key(next(t, i), t[i]), -1, Integer::sum);
        }
        IntList edges = new IntList();
        for (int i = 0; i < t.length; i++) {
            int to = next(t, i);
            Integer left = surplus.put(key(t[i], to), 0);
            for (int k = 0; left != null && k < left; k++) {
                edges.add(t[i]);
                edges.add(to);
            }
        }
        return edges.toArray();
    }

    private static int next(int[] t, int corner) {
        return t[corner % 3 == 2 ? corner - 2 : corner + 1];
    }

    private static long key(int from, int to) {
        return ((long) from << 32) | to;
    }

    /** The closed surface with its vertices at other positions. */
    public TriangleMesh at(double[] positions) {
        double[] p = Arrays.copyOf(positions, 3 * (vertices + rims.length));
        for (int i = 0; i < rims.length; i++) {
            for (int v : rims[i]) {
                for (int axis = 0; axis < 3; axis++) {
                    p[3 * (vertices + i) + axis] += positions[3 * v + axis] / rims[i].length;
                }
            }
        }
        return new TriangleMesh(p, triangles);
    }
}
