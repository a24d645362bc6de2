package org.phrenic.anatomy.virtual;

import java.util.HashMap;
import java.util.Map;
import org.phrenic.geometry.TriangleMesh;

/** What tests ask of a closed surface. */
final class Surface {
    final TriangleMesh mesh;
    private final double[] box;

    Surface(TriangleMesh mesh) {
        this.mesh = mesh;
        box = mesh.bounds();
    }

    double[] vertex(int v) {
        return V3.of(mesh.x(v), mesh.y(v), mesh.z(v));
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
            six += V3.dot(corner(t, 0), V3.cross(corner(t, 1), corner(t, 2)));
        }
        return six / 6000;
    }

    double areaMm2(int triangle) {
        double[] a = corner(triangle, 0);
        return V3.length(V3.cross(V3.minus(corner(triangle, 1), a), V3.minus(corner(triangle, 2), a))) / 2;
    }

    double smallestAngleDeg(int triangle) {
        double least = 180;
        for (int k = 0; k < 3; k++) {
            double[] u = V3.minus(corner(triangle, (k + 1) % 3), corner(triangle, k));
            double[] v = V3.minus(corner(triangle, (k + 2) % 3), corner(triangle, k));
            double angle = Math.atan2(V3.length(V3.cross(u, v)), V3.dot(u, v));
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

    /** Winding number by solid angles (Van Oosterom and Strackee 1983), above one half inside. */
    boolean contains(double[] p) {
        if (!near(p, 0)) {
            return false;
        }
        double sum = 0;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double[] a = V3.minus(corner(t, 0), p);
            double[] b = V3.minus(corner(t, 1), p);
            double[] c = V3.minus(corner(t, 2), p);
            double la = V3.length(a);
            double lb = V3.length(b);
            double lc = V3.length(c);
            double top = V3.dot(a, V3.cross(b, c));
            double bottom = la * lb * lc + V3.dot(a, b) * lc + V3.dot(b, c) * la + V3.dot(c, a) * lb;
            sum += 2 * Math.atan2(top, bottom);
        }
        return sum > 2 * Math.PI;
    }

    /** How many vertices of the other surface lie inside this one. */
    int verticesInside(Surface other) {
        int inside = 0;
        for (int v = 0; v < other.mesh.vertexCount(); v++) {
            inside += contains(other.vertex(v)) ? 1 : 0;
        }
        return inside;
    }

    /** Smallest distance from a vertex of the other surface to this one, 0 if one lies inside; beyond 8 mm infinite. */
    double gap(Surface other) {
        double least = Double.POSITIVE_INFINITY;
        for (int v = 0; v < other.mesh.vertexCount(); v++) {
            double[] p = other.vertex(v);
            if (near(p, 8)) {
                least = contains(p) ? 0 : Math.min(least, distance(p));
            }
        }
        return least;
    }

    double distance(double[] p) {
        double least = Double.POSITIVE_INFINITY;
        for (int t = 0; t < mesh.triangleCount(); t++) {
            least = Math.min(least, distance(p, corner(t, 0), corner(t, 1), corner(t, 2)));
        }
        return least;
    }

    /** Point to triangle, Ericson, Real-Time Collision Detection, 5.1.5, by its three edges and its plane. */
    private static double distance(double[] p, double[] a, double[] b, double[] c) {
        double[] n = V3.cross(V3.minus(b, a), V3.minus(c, a));
        double[][] corners = {a, b, c};
        boolean above = true;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double[] from = corners[k];
            double[] edge = V3.minus(corners[(k + 1) % 3], from);
            double[] q = V3.minus(p, from);
            above &= V3.dot(V3.cross(n, edge), q) >= 0;
            double t = Math.max(0, Math.min(1, V3.dot(q, edge) / V3.dot(edge, edge)));
            least = Math.min(least, V3.length(V3.add(q, edge, -t)));
        }
        return above ? Math.abs(V3.dot(V3.minus(p, a), n)) / V3.length(n) : least;
    }
}
