package org.phrenic.mesh.io;

import java.util.Arrays;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.Vectors;

/**
 * Triangulates polygons. A fan from the first corner is used where it covers the polygon (any convex polygon).
 * Otherwise ears are clipped (Meisters 1975, "Polygons have ears", doi 10.1080/00029890.1975.11993898) in the
 * projection along the Newell normal. A degenerate or self-intersecting polygon with no ear left is completed as a fan,
 * so n corners always give n - 2 triangles.
 */
final class PolygonTriangulator {
    private PolygonTriangulator() {}

    /**
     * Writes the triangles of one polygon.
     *
     * @param positions x, y, z of each vertex
     * @param corners vertex indices; the polygon is {@code corners[from..to)}
     * @param triangles receives the triangles, from index {@code at}
     * @return the index after the last one written
     */
    static int triangulate(double[] positions, int[] corners, int from, int to, int[] triangles, int at) {
        if (to - from == 3) {
            return put(triangles, at, corners[from], corners[from + 1], corners[from + 2]);
        }
        double[] normal = newellNormal(positions, corners, from, to);
        int[] rest = Arrays.copyOfRange(corners, from, to);
        int count = rest.length;
        int filled = at;
        while (count > 3 && !fanCovers(positions, rest, count, normal)) {
            int ear = ear(positions, rest, count, normal);
            if (ear < 0) {
                break;
            }
            filled = put(triangles, filled, rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]);
            System.arraycopy(rest, ear + 1, rest, ear, count - ear - 1);
            count--;
        }
        for (int i = 1; i + 1 < count; i++) {
            filled = put(triangles, filled, rest[0], rest[i], rest[i + 1]);
        }
        return filled;
    }

    private static int put(int[] triangles, int at, int a, int b, int c) {
        triangles[at] = a;
        triangles[at + 1] = b;
        triangles[at + 2] = c;
        return at + 3;
    }

    private static double[] newellNormal(double[] p, int[] corners, int from, int to) {
        double[] normal = new double[3];
        for (int i = from; i < to; i++) {
            int a = 3 * corners[i];
            int b = 3 * corners[i + 1 < to ? i + 1 : from];
            normal[0] += (p[a + 1] - p[b + 1]) * (p[a + 2] + p[b + 2]);
            normal[1] += (p[a + 2] - p[b + 2]) * (p[a] + p[b]);
            normal[2] += (p[a] - p[b]) * (p[a + 1] + p[b + 1]);
        }
        return normal;
    }

    /**
     * Whether all triangles of the fan have the orientation of the polygon. It is then star-shaped about its first
     * corner.
     */
    private static boolean fanCovers(double[] p, int[] corners, int count, double[] normal) {
        for (int i = 1; i + 1 < count; i++) {
            if (orientation(p, corners[0], corners[i], corners[i + 1], normal) <= 0) {
                return false;
            }
        }
        return true;
    }

    private static int ear(double[] p, int[] corners, int count, double[] normal) {
        for (int i = 0; i < count; i++) {
            int before = corners[(i + count - 1) % count];
            int after = corners[(i + 1) % count];
            if (orientation(p, before, corners[i], after, normal) > 0 && isEmpty(p, corners, count, i, normal)) {
                return i;
            }
        }
        return -1;
    }

    private static boolean isEmpty(double[] p, int[] corners, int count, int tip, double[] normal) {
        int a = corners[(tip + count - 1) % count];
        int b = corners[tip];
        int c = corners[(tip + 1) % count];
        for (int i = 0; i < count; i++) {
            int v = corners[i];
            if (v != a
                    && v != b
                    && v != c
                    && orientation(p, a, b, v, normal) >= 0
                    && orientation(p, b, c, v, normal) >= 0
                    && orientation(p, c, a, v, normal) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** Twice the signed area of triangle a b c projected along {@code normal}, times the length of the normal. */
    private static double orientation(double[] p, int a, int b, int c, double[] normal) {
        double[] cross = new double[3];
        Triangles.cross(p, 3 * a, 3 * b, 3 * c, cross);
        return Vectors.dot(normal, cross);
    }
}
