package org.phrenic.anatomy.virtual;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** What tests ask of a closed surface. */
final class SurfaceChecks {
    final TriangleMesh mesh;
    private static final double SLAB_MM = 4;

    private final double[] box;
    /** Triangles by the slabs of height they reach into. */
    private int[][] slabs;

    /** The surface of this name. */
    static SurfaceChecks of(Thorax thorax, String name) {
        return new SurfaceChecks(thorax.find(name).orElseThrow().mesh());
    }

    SurfaceChecks(TriangleMesh mesh) {
        this.mesh = mesh;
        box = mesh.bounds();
        slabs = sortIntoSlabs();
    }

    double[] vertex(int v) {
        return Vectors.of(mesh.x(v), mesh.y(v), mesh.z(v));
    }

    private double[] corner(int triangle, int k) {
        return vertex(mesh.triangles()[3 * triangle + k]);
    }

    /** Every edge belongs to exactly two triangles, which run along it in opposite ways. */
    boolean isClosedAndOriented() {
        Map<Long, Integer> count = new HashMap<>();
        int[] t = mesh.triangles();
        for (int c = 0; c < t.length; c++) {
            long a = t[c];
            long b = t[c % 3 == 2 ? c - 2 : c + 1];
            count.merge(a << 32 | b, 1, Integer::sum);
        }
        for (Map.Entry<Long, Integer> edge : count.entrySet()) {
            long back = edge.getKey() << 32 | edge.getKey() >>> 32;
            if (edge.getValue() != 1 || count.getOrDefault(back, 0) != 1) {
                return false;
            }
        }
        return true;
    }

    /** 2 for a ball, 0 for a ring. */
    int eulerCharacteristic() {
        return mesh.vertexCount() - mesh.triangleCount() / 2;
    }

    /** Signed volume, ml: positive if the triangles look outward. */
    double volumeMl() {
        double six = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            six += Vectors.dot(corner(t, 0), Vectors.cross(corner(t, 1), corner(t, 2)));
        }
        return six / 6000;
    }

    double shortestEdge() {
        int[] t = mesh.triangles();
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < t.length; c++) {
            least = Math.min(least, Vectors.distance(vertex(t[c]), vertex(t[c % 3 == 2 ? c - 2 : c + 1])));
        }
        return least;
    }

    double areaMm2(int triangle) {
        double[] a = corner(triangle, 0);
        return Vectors.length(Vectors.cross(
                        Vectors.subtract(corner(triangle, 1), a), Vectors.subtract(corner(triangle, 2), a)))
                / 2;
    }

    double smallestAngleDeg(int triangle) {
        double least = 180;
        for (int k = 0; k < 3; k++) {
            double[] u = Vectors.subtract(corner(triangle, (k + 1) % 3), corner(triangle, k));
            double[] v = Vectors.subtract(corner(triangle, (k + 2) % 3), corner(triangle, k));
            double angle = Math.atan2(Vectors.length(Vectors.cross(u, v)), Vectors.dot(u, v));
            least = Math.min(least, Math.toDegrees(angle));
        }
        return least;
    }

    private boolean near(double[] p, double margin) {
        for (int axis = 0; axis < 3; axis++) {
            if (p[axis] < box[axis] - margin || p[axis] > box[3 + axis] + margin) {
                return false;
            }
        }
        return true;
    }

    private int slab(double z) {
        return Math.max(0, Math.min(slabs.length - 1, (int) ((z - box[2]) / SLAB_MM)));
    }

    private int[][] sortIntoSlabs() {
        List<List<Integer>> lists = new ArrayList<>();
        for (int i = 0; i <= (box[5] - box[2]) / SLAB_MM; i++) {
            lists.add(new ArrayList<>());
        }
        slabs = new int[lists.size()][];
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double[] a = corner(t, 0);
            double[] b = corner(t, 1);
            double[] c = corner(t, 2);
            int from = slab(Math.min(a[2], Math.min(b[2], c[2])));
            int to = slab(Math.max(a[2], Math.max(b[2], c[2])));
            for (int i = from; i <= to; i++) {
                lists.get(i).add(t);
            }
        }
        return lists.stream()
                .map(list -> list.stream().mapToInt(Integer::intValue).toArray())
                .toArray(int[][]::new);
    }

    /** Whether a ray to the left leaves the surface an odd number of times. */
    boolean contains(double[] p) {
        if (!near(p, 0)) {
            return false;
        }
        boolean inside = false;
        // Off the vertices' own heights by less than matters, so that the ray meets no edge.
        double y = p[1] + 1.37e-7;
        double z = p[2] + 2.91e-7;
        for (int t : slabs[slab(z)]) {
            double[] a = corner(t, 0);
            double[] b = corner(t, 1);
            double[] c = corner(t, 2);
            double u = (b[1] - a[1]) * (z - a[2]) - (b[2] - a[2]) * (y - a[1]);
            double v = (c[1] - b[1]) * (z - b[2]) - (c[2] - b[2]) * (y - b[1]);
            double w = (a[1] - c[1]) * (z - c[2]) - (a[2] - c[2]) * (y - c[1]);
            boolean hit = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
            if (hit && (v * a[0] + w * b[0] + u * c[0]) / (u + v + w) > p[0]) {
                inside = !inside;
            }
        }
        return inside;
    }

    /** How many vertices of the other surface lie inside this one. */
    int verticesInside(SurfaceChecks other) {
        int inside = 0;
        for (int v = 0; v < other.mesh.vertexCount(); v++) {
            inside += contains(other.vertex(v)) ? 1 : 0;
        }
        return inside;
    }

    /** Smallest distance from a vertex of the other surface to this one, 0 if one lies inside; infinite beyond 8 mm. */
    double gap(SurfaceChecks other) {
        double least = Double.POSITIVE_INFINITY;
        for (int v = 0; v < other.mesh.vertexCount() && least > 0; v++) {
            double[] p = other.vertex(v);
            if (near(p, 8)) {
                least = contains(p) ? 0 : Math.min(least, distance(p, 8));
            }
        }
        return least;
    }

    /** Distance to the surface; infinite where it is more than {@code most} mm. */
    double distance(double[] p, double most) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = slab(p[2] - most); i <= slab(p[2] + most); i++) {
            for (int t : slabs[i]) {
                double[] a = corner(t, 0);
                if (Math.abs(a[0] - p[0]) < most + 30 && Math.abs(a[1] - p[1]) < most + 30) {
                    least = Math.min(least, distance(p, a, corner(t, 1), corner(t, 2)));
                }
            }
        }
        return least <= most ? least : Double.POSITIVE_INFINITY;
    }

    /** Point to triangle, Ericson, Real-Time Collision Detection, 5.1.5, by its three edges and its plane. */
    private static double distance(double[] p, double[] a, double[] b, double[] c) {
        double[] n = Vectors.cross(Vectors.subtract(b, a), Vectors.subtract(c, a));
        double[][] corners = {a, b, c};
        boolean above = true;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double[] from = corners[k];
            double[] edge = Vectors.subtract(corners[(k + 1) % 3], from);
            double[] q = Vectors.subtract(p, from);
            above &= Vectors.dot(Vectors.cross(n, edge), q) >= 0;
            double t = Math.max(0, Math.min(1, Vectors.dot(q, edge) / Vectors.dot(edge, edge)));
            least = Math.min(least, Vectors.length(Vectors.addScaled(q, edge, -t)));
        }
        return above ? Math.abs(Vectors.dot(Vectors.subtract(p, a), n)) / Vectors.length(n) : least;
    }
}
