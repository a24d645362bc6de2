package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * What a path touches, by looking at every triangle where it is in space: no tree, no change of axes, and another
 * arithmetic than the program's (Moeller and Trumbore for piercing; the distance by a golden section along the path,
 * for the distance of a convex set from the points of a line is convex).
 */
final class BruteForcePath {
    private static final double GOLDEN = 0.5 * (Math.sqrt(5) - 1);
    private static final int SECTIONS = 60;
    /** Triangles are looked at that may be this much farther from a path than the limit. */
    private static final double NEAR_MM = 0.01;

    /**
     * Of each triangle, nine coordinates of corners, and its centre with the radius of the sphere around it.
     *
     * @param box of all corners: minimum x, y, z, then maximum x, y, z, mm
     */
    private record Part(NoGoZone what, String name, double limit, double[] corners, double[] spheres, double[] box) {
        Part(NoGoZone what, String name, double limit, double[] corners) {
            this(what, name, limit, corners, spheres(corners), box(corners));
        }

        private static double[] box(double[] corners) {
            double[] out = {
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.NEGATIVE_INFINITY
            };
            for (int c = 0; c < corners.length; c++) {
                out[c % 3] = Math.min(out[c % 3], corners[c]);
                out[3 + c % 3] = Math.max(out[3 + c % 3], corners[c]);
            }
            return out;
        }

        /** Whether a path lies farther than a limit from all triangles along an axis. */
        boolean isFar(double[] from, double[] to, double limit) {
            for (int axis = 0; axis < 3; axis++) {
                if (Math.min(from[axis], to[axis]) > box[3 + axis] + limit
                        || Math.max(from[axis], to[axis]) < box[axis] - limit) {
                    return true;
                }
            }
            return false;
        }

        private static double[] spheres(double[] c) {
            double[] out = new double[c.length / 9 * 4];
            for (int o = 0, s = 0; o < c.length; o += 9, s += 4) {
                for (int axis = 0; axis < 3; axis++) {
                    out[s + axis] = (c[o + axis] + c[o + 3 + axis] + c[o + 6 + axis]) / 3;
                }
                for (int k = 0; k < 9; k += 3) {
                    double x = c[o + k] - out[s];
                    double y = c[o + k + 1] - out[s + 1];
                    double z = c[o + k + 2] - out[s + 2];
                    out[s + 3] = Math.max(out[s + 3], Math.sqrt(x * x + y * y + z * z));
                }
            }
            return out;
        }

        /** Whether a path comes nearer to the sphere around a triangle than a limit. */
        boolean isNear(int triangle, double[] from, double[] d, double limit) {
            double mx = spheres[4 * triangle] - from[0];
            double my = spheres[4 * triangle + 1] - from[1];
            double mz = spheres[4 * triangle + 2] - from[2];
            double s = (mx * d[0] + my * d[1] + mz * d[2]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            s = Math.max(0, Math.min(1, s));
            double gx = mx - s * d[0];
            double gy = my - s * d[1];
            double gz = mz - s * d[2];
            double reach = limit + spheres[4 * triangle + 3];
            return gx * gx + gy * gy + gz * gz <= reach * reach;
        }
    }

    private final List<Part> parts = new ArrayList<>();
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    /** How near the last answer was to another, mm. */
    double slack;

    BruteForcePath(List<Surface> surfaces, Frame frame, Needle needle) {
        for (int i = 0; i < surfaces.size(); i++) {
            Surface s = surfaces.get(i);
            NoGoZone what = NoGoZone.of(s.kind()).orElse(null);
            if (what == null) {
                continue;
            }
            double[] p = new double[s.rest().positions().length];
            frame.writePositions(s, i, p);
            parts.add(new Part(what, s.name(), needle.radiusMm(), corners(s.rest(), p, false)));
            if (s.kind() == StructureKind.RIB) {
                parts.add(new Part(NoGoZone.VESSELS, s.name(), 5, corners(s.rest(), p, true)));
            }
        }
    }

    /** Corners of all triangles, or of those that look down at rest. */
    private static double[] corners(TriangleMesh rest, double[] p, boolean down) {
        int[] t = rest.triangles();
        double[] normals = org.phrenic.mesh.MeshMeasure.triangleNormals(rest);
        List<Integer> kept = new ArrayList<>();
        for (int k = 0; k < t.length / 3; k++) {
            if (!down || normals[3 * k + 2] < -0.5) {
                kept.add(k);
            }
        }
        double[] out = new double[9 * kept.size()];
        for (int i = 0; i < kept.size(); i++) {
            for (int c = 0; c < 3; c++) {
                System.arraycopy(p, 3 * t[3 * kept.get(i) + c], out, 9 * i + 3 * c, 3);
            }
        }
        return out;
    }

    Set<NoGoZone> touched(double[] from, double[] to) {
        Set<NoGoZone> out = EnumSet.noneOf(NoGoZone.class);
        slack = Double.POSITIVE_INFINITY;
        double[] d = Vectors.subtract(to, from);
        for (Part part : parts) {
            if (part.isFar(from, to, part.limit + NEAR_MM)) {
                continue;
            }
            double least = Double.POSITIVE_INFINITY;
            double[] c = part.corners;
            for (int o = 0; o < c.length; o += 9) {
                if (part.isNear(o / 9, from, d, part.limit + NEAR_MM)) {
                    least = Math.min(least, pierces(c, o, from, d) ? 0 : alongPath(c, o, from, d));
                }
            }
            slack = Math.min(slack, Math.abs(least - part.limit));
            if (least < part.limit) {
                out.add(part.what);
            }
        }
        return out;
    }

    /** Names of the structures of some zones whose triangles a path passes through. */
    Set<String> pierced(double[] from, double[] to, Set<NoGoZone> zones) {
        Set<String> out = new TreeSet<>();
        double[] d = Vectors.subtract(to, from);
        for (Part part : parts) {
            if (!zones.contains(part.what) || part.isFar(from, to, NEAR_MM)) {
                continue;
            }
            for (int o = 0; o < part.corners.length; o += 9) {
                if (part.isNear(o / 9, from, d, NEAR_MM) && pierces(part.corners, o, from, d)) {
                    out.add(part.name);
                }
            }
        }
        return out;
    }

    private static boolean pierces(double[] c, int o, double[] from, double[] d) {
        double[] e1 = {c[o + 3] - c[o], c[o + 4] - c[o + 1], c[o + 5] - c[o + 2]};
        double[] e2 = {c[o + 6] - c[o], c[o + 7] - c[o + 1], c[o + 8] - c[o + 2]};
        double[] p = cross(d, e2);
        double determinant = Vectors.dot(e1, p);
        double[] t = {from[0] - c[o], from[1] - c[o + 1], from[2] - c[o + 2]};
        double u = Vectors.dot(t, p) / determinant;
        double[] q = cross(t, e1);
        double v = Vectors.dot(d, q) / determinant;
        double along = Vectors.dot(e2, q) / determinant;
        return u >= 0 && v >= 0 && u + v <= 1 && along >= 0 && along <= 1;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private double alongPath(double[] c, int o, double[] from, double[] d) {
        TriangleTree single =
                new TriangleTree(new TriangleMesh(java.util.Arrays.copyOfRange(c, o, o + 9), new int[] {0, 1, 2}));
        double low = 0;
        double high = 1;
        double a = high - GOLDEN * (high - low);
        double b = low + GOLDEN * (high - low);
        double atA = at(single, from, d, a);
        double atB = at(single, from, d, b);
        for (int i = 0; i < SECTIONS; i++) {
            if (atA < atB) {
                high = b;
                b = a;
                atB = atA;
                a = high - GOLDEN * (high - low);
                atA = at(single, from, d, a);
            } else {
                low = a;
                a = b;
                atA = atB;
                b = low + GOLDEN * (high - low);
                atB = at(single, from, d, b);
            }
        }
        return Math.min(Math.min(atA, atB), Math.min(at(single, from, d, 0), at(single, from, d, 1)));
    }

    private double at(TriangleTree single, double[] from, double[] d, double s) {
        double[] p = Vectors.addScaled(from, d, s);
        single.closest(p[0], p[1], p[2], hit);
        return Math.sqrt(hit.distanceSquared);
    }
}
