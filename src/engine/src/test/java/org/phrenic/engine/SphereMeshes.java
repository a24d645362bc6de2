package org.phrenic.engine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/** Closed surfaces made from an octahedron. */
public final class SphereMeshes {
    private SphereMeshes() {}

    /** A sphere of 4^level 8 triangles, anticlockwise seen from outside. */
    public static TriangleSurface sphere(double radius, int level) {
        List<double[]> nodes = new ArrayList<>(List.of(
                new double[] {1, 0, 0},
                new double[] {0, 1, 0},
                new double[] {-1, 0, 0},
                new double[] {0, -1, 0},
                new double[] {0, 0, 1},
                new double[] {0, 0, -1}));
        int[] triangles = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};
        for (int l = 0; l < level; l++) {
            Map<Long, Integer> middles = new HashMap<>();
            int[] finer = new int[4 * triangles.length];
            for (int t = 0; t < triangles.length; t += 3) {
                int a = triangles[t];
                int b = triangles[t + 1];
                int c = triangles[t + 2];
                int ab = middle(nodes, middles, a, b);
                int bc = middle(nodes, middles, b, c);
                int ca = middle(nodes, middles, c, a);
                int[] four = {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca};
                System.arraycopy(four, 0, finer, 4 * t, 12);
            }
            triangles = finer;
        }
        double[] x = new double[3 * nodes.size()];
        for (int i = 0; i < nodes.size(); i++) {
            for (int axis = 0; axis < 3; axis++) {
                x[3 * i + axis] = radius * nodes.get(i)[axis];
            }
        }
        return new TriangleSurface(x, triangles);
    }

    private static int middle(List<double[]> nodes, Map<Long, Integer> middles, int a, int b) {
        return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
            double[] p = nodes.get(a);
            double[] q = nodes.get(b);
            double[] m = {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
            double length = Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
            nodes.add(new double[] {m[0] / length, m[1] / length, m[2] / length});
            return nodes.size() - 1;
        });
    }

    /**
     * The two faces of a thin sheet as one closed surface, domed like a diaphragm: the upper half of a sphere and,
     * {@code gap} below it, its other half folded up. As in a mesh from a scan valences vary about 6: {@code share} of
     * all edges are flipped at random, valences staying between 4 and 8.
     */
    public static TriangleSurface doubleDome(double radius, double gap, int level, double share) {
        TriangleSurface sphere = sphere(radius, level);
        double[] x = sphere.positions().clone();
        for (int i = 2; i < x.length; i += 3) {
            if (x[i] < 0) {
                x[i] = -x[i] * (radius - gap) / radius - gap;
            }
        }
        return new TriangleSurface(x, flipped(sphere.triangles().clone(), sphere.vertexCount(), share));
    }

    private static int[] flipped(int[] triangles, int nodes, double share) {
        int[] valence = new int[nodes];
        Arrays.stream(triangles).forEach(i -> valence[i]++);
        Random random = new Random(5);
        int wanted = (int) (share * triangles.length / 2);
        // The half edge a -> b of each triangle, by its two ends.
        TreeMap<Long, Integer> halfEdge = new TreeMap<>();
        for (int i = 0; i < triangles.length; i++) {
            halfEdge.put(key(triangles[i], triangles[next(i)]), i);
        }
        for (int tries = 0; tries < 20 * wanted && wanted > 0; tries++) {
            int i = random.nextInt(triangles.length);
            int a = triangles[i];
            int b = triangles[next(i)];
            int c = triangles[next(next(i))];
            int j = halfEdge.get(key(b, a));
            int d = triangles[next(next(j))];
            boolean room = valence[a] > 4 && valence[b] > 4 && valence[c] < 8 && valence[d] < 8;
            if (!room || halfEdge.containsKey(key(c, d)) || halfEdge.containsKey(key(d, c))) {
                continue;
            }
            valence[a]--;
            valence[b]--;
            valence[c]++;
            valence[d]++;
            halfEdge.remove(key(a, b));
            halfEdge.remove(key(b, a));
            int t = i / 3 * 3;
            int u = j / 3 * 3;
            System.arraycopy(new int[] {a, d, c}, 0, triangles, t, 3);
            System.arraycopy(new int[] {d, b, c}, 0, triangles, u, 3);
            for (int at : new int[] {t, t + 1, t + 2, u, u + 1, u + 2}) {
                halfEdge.put(key(triangles[at], triangles[next(at)]), at);
            }
            wanted--;
        }
        return triangles;
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    private static long key(int a, int b) {
        return (long) a << 32 | b;
    }

    /** Vertices as x, y, z in turn, and the three vertices of each triangle. */
    @SuppressWarnings("ArrayRecordComponent")
    public record TriangleSurface(double[] positions, int[] triangles) {
        public int vertexCount() {
            return positions.length / 3;
        }

        public int triangleCount() {
            return triangles.length / 3;
        }
    }
}
