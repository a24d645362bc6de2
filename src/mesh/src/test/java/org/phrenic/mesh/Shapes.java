package org.phrenic.mesh;

import java.util.HashMap;
import java.util.Map;

/** Surfaces whose figures are known in closed form. */
public final class Shapes {
    private Shapes() {}

    /** Axis-aligned box with corners at 0 and (a, b, c), 8 vertices, 12 triangles, facing outward. */
    public static TriangleMesh box(double a, double b, double c) {
        double[] positions = {0, 0, 0, a, 0, 0, a, b, 0, 0, b, 0, 0, 0, c, a, 0, c, a, b, c, 0, b, c};
        int[] triangles = {
            0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
        };
        return new TriangleMesh(positions, triangles);
    }

    /**
     * An icosahedron, each triangle cut into four {@code levels} times, on a sphere about the origin; 10 * 4^levels + 2
     * vertices.
     */
    public static TriangleMesh sphere(double radius, int levels) {
        double g = (1 + Math.sqrt(5)) / 2;
        double[] p = {
            -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g, 0, -1, g, 0, 1, -g, 0,
            -1, -g, 0, 1
        };
        int[] t = {
            0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4,
            3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1
        };
        for (int level = 0; level < levels; level++) {
            Map<Long, Integer> middle = new HashMap<>();
            double[] finer = java.util.Arrays.copyOf(p, p.length + 3 * (t.length / 2));
            int[] cut = new int[4 * t.length];
            int n = p.length / 3;
            for (int k = 0; k < t.length; k += 3) {
                int[] m = new int[3];
                for (int i = 0; i < 3; i++) {
                    int a = t[k + i];
                    int b = t[k + (i + 1) % 3];
                    Integer known = middle.get(((long) Math.min(a, b) << 32) | Math.max(a, b));
                    if (known == null) {
                        known = n + middle.size();
                        middle.put(((long) Math.min(a, b) << 32) | Math.max(a, b), known);
                        for (int x = 0; x < 3; x++) {
                            finer[3 * known + x] = (finer[3 * a + x] + finer[3 * b + x]) / 2;
                        }
                    }
                    m[i] = known;
                }
                int[] four = {t[k], m[0], m[2], t[k + 1], m[1], m[0], t[k + 2], m[2], m[1], m[0], m[1], m[2]};
                System.arraycopy(four, 0, cut, 4 * k, 12);
            }
            p = finer;
            t = cut;
        }
        for (int i = 0; i < p.length; i += 3) {
            double scale = radius / Math.sqrt(p[i] * p[i] + p[i + 1] * p[i + 1] + p[i + 2] * p[i + 2]);
            p[i] *= scale;
            p[i + 1] *= scale;
            p[i + 2] *= scale;
        }
        return new TriangleMesh(p, t);
    }

    /** Torus about z: {@code around} steps about the axis, {@code across} about the tube. */
    public static TriangleMesh torus(double major, double minor, int around, int across) {
        double[] p = new double[3 * around * across];
        for (int i = 0; i < around; i++) {
            double u = 2 * Math.PI * i / around;
            for (int j = 0; j < across; j++) {
                double v = 2 * Math.PI * j / across;
                int k = 3 * (i * across + j);
                p[k] = (major + minor * Math.cos(v)) * Math.cos(u);
                p[k + 1] = (major + minor * Math.cos(v)) * Math.sin(u);
                p[k + 2] = minor * Math.sin(v);
            }
        }
        return new TriangleMesh(p, grid(around, across, true, true));
    }

    /**
     * Open tube about z from 0 to {@code height}, facing outward: {@code around} steps about, {@code along} steps up.
     */
    public static TriangleMesh tube(double radius, double height, int around, int along) {
        double[] p = new double[3 * around * (along + 1)];
        for (int i = 0; i < around; i++) {
            double u = 2 * Math.PI * i / around;
            for (int j = 0; j <= along; j++) {
                int k = 3 * (i * (along + 1) + j);
                p[k] = radius * Math.cos(u);
                p[k + 1] = radius * Math.sin(u);
                p[k + 2] = height * j / along;
            }
        }
        return new TriangleMesh(p, grid(around, along + 1, true, false));
    }

    /** Flat rectangle in z = 0, facing +z, {@code columns} by {@code rows} vertices. */
    public static TriangleMesh sheet(double width, double depth, int columns, int rows) {
        double[] p = new double[3 * columns * rows];
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                p[3 * (i * rows + j)] = width * i / (columns - 1);
                p[3 * (i * rows + j) + 1] = depth * j / (rows - 1);
            }
        }
        return new TriangleMesh(p, grid(columns, rows, false, false));
    }

    private static int[] grid(int m, int n, boolean wrapM, boolean wrapN) {
        int cellsM = wrapM ? m : m - 1;
        int cellsN = wrapN ? n : n - 1;
        int[] t = new int[6 * cellsM * cellsN];
        int k = 0;
        for (int i = 0; i < cellsM; i++) {
            for (int j = 0; j < cellsN; j++) {
                int a = i * n + j;
                int b = (i + 1) % m * n + j;
                int c = (i + 1) % m * n + (j + 1) % n;
                int d = i * n + (j + 1) % n;
                int[] two = {a, b, c, a, c, d};
                System.arraycopy(two, 0, t, k, 6);
                k += 6;
            }
        }
        return t;
    }

    /** Both meshes side by side in one, nothing shared. */
    public static TriangleMesh join(TriangleMesh first, TriangleMesh second) {
        double[] p = new double[first.positions().length + second.positions().length];
        System.arraycopy(first.positions(), 0, p, 0, first.positions().length);
        System.arraycopy(second.positions(), 0, p, first.positions().length, second.positions().length);
        int[] t = new int[first.triangles().length + second.triangles().length];
        System.arraycopy(first.triangles(), 0, t, 0, first.triangles().length);
        for (int i = 0; i < second.triangles().length; i++) {
            t[first.triangles().length + i] = second.triangles()[i] + first.vertexCount();
        }
        return new TriangleMesh(p, t);
    }

    public static TriangleMesh moved(TriangleMesh mesh, double dx, double dy, double dz) {
        double[] p = mesh.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] += dx;
            p[i + 1] += dy;
            p[i + 2] += dz;
        }
        return mesh.withPositions(p);
    }

    /** A triangle soup: every corner a vertex of its own, as an STL file holds a surface. */
    public static TriangleMesh soup(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        double[] p = new double[3 * t.length];
        int[] own = new int[t.length];
        for (int i = 0; i < t.length; i++) {
            System.arraycopy(mesh.positions(), 3 * t[i], p, 3 * i, 3);
            own[i] = i;
        }
        return new TriangleMesh(p, own);
    }
}
