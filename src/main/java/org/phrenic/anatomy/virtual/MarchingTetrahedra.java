package org.phrenic.anatomy.virtual;

import java.util.Arrays;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.geometry.Vectors;

/**
 * The surface of a region as triangles: each cube of a grid is cut into six tetrahedra along its diagonal (Kuhn), and in each
 * the surface is one or two triangles. Always closed and manifold if the region ends inside the grid.
 */
final class MarchingTetrahedra {
    private static final int[][] STEPS = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    /** The six ways from a cube's corner 0 to corner 7 (bits: x 1, y 2, z 4). */
    private static final int[][] TETRAHEDRA = {
        {0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}
    };

    private static final int[][] NONE = {};
    /** A cut closer to a corner than this share of the edge is moved there: no needles. */
    private static final double LEAST_SHARE = 0.12;

    private final int[] size = new int[3];
    private final double[] origin;
    private final double step;
    private final double[] value;
    private final int[] cut;
    private double[] positions = new double[3 * 1024];
    private int vertices;
    private int[] triangles = new int[3 * 2048];
    private int corners;

    private MarchingTetrahedra(Field field, double[] low, double[] high, double step) {
        this.step = step;
        origin = low;
        for (int a = 0; a < 3; a++) {
            size[a] = (int) Math.ceil((high[a] - low[a]) / step) + 1;
        }
        value = new double[size[0] * size[1] * size[2]];
        cut = new int[7 * value.length];
        Arrays.fill(cut, -1);
        for (int k = 0, n = 0; k < size[2]; k++) {
            for (int j = 0; j < size[1]; j++) {
                for (int i = 0; i < size[0]; i++) {
                    value[n++] = field.at(low[0] + i * step, low[1] + j * step, low[2] + k * step);
                }
            }
        }
    }

    /** Surface of the region inside this box, in triangles of about {@code step} mm. */
    static TriangleMesh surface(Field field, double[] low, double[] high, double step) {
        MarchingTetrahedra march = new MarchingTetrahedra(field, low, high, step);
        int[] corner = new int[8];
        for (int k = 0; k < march.size[2] - 1; k++) {
            for (int j = 0; j < march.size[1] - 1; j++) {
                for (int i = 0; i < march.size[0] - 1; i++) {
                    int inside = 0;
                    for (int c = 0; c < 8; c++) {
                        corner[c] = march.index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
                        inside += march.value[corner[c]] < 0 ? 1 : 0;
                    }
                    for (int[] t : inside % 8 == 0 ? NONE : TETRAHEDRA) {
                        march.tetrahedron(corner[t[0]], corner[t[1]], corner[t[2]], corner[t[3]]);
                    }
                }
            }
        }
        return new TriangleMesh(
                Arrays.copyOf(march.positions, 3 * march.vertices), Arrays.copyOf(march.triangles, march.corners));
    }

    private int index(int i, int j, int k) {
        return (k * size[1] + j) * size[0] + i;
    }

    private double[] grid(int n) {
        int i = n % size[0];
        int j = n / size[0] % size[1];
        int k = n / (size[0] * size[1]);
        return Vectors.of(origin[0] + i * step, origin[1] + j * step, origin[2] + k * step);
    }

    private void tetrahedron(int... corner) {
        int[] in = new int[4];
        int[] out = new int[4];
        int inside = 0;
        int outside = 0;
        for (int c : corner) {
            if (value[c] < 0) {
                in[inside++] = c;
            } else {
                out[outside++] = c;
            }
        }
        if (inside == 1) {
            triangle(in[0], out[0], cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]));
        } else if (inside == 3) {
            triangle(in[0], out[0], cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]));
        } else if (inside == 2) {
            int a = cut(in[0], out[0]);
            int b = cut(in[0], out[1]);
            int c = cut(in[1], out[1]);
            int d = cut(in[1], out[0]);
            triangle(in[0], out[0], a, b, c);
            triangle(in[0], out[0], a, c, d);
        }
    }

    /** Vertex on the grid edge between two corners of a tetrahedron. */
    private int cut(int a, int b) {
        int low = Math.min(a, b);
        int high = Math.max(a, b);
        double[] p = grid(low);
        double[] q = grid(high);
        int kind = 0;
        while ((int) Math.round((q[0] - p[0]) / step) != STEPS[kind][0]
                || (int) Math.round((q[1] - p[1]) / step) != STEPS[kind][1]
                || (int) Math.round((q[2] - p[2]) / step) != STEPS[kind][2]) {
            kind++;
        }
        int key = 7 * low + kind;
        if (cut[key] < 0) {
            double t = value[low] / (value[low] - value[high]);
            double[] r = Vectors.lerp(p, q, Math.max(LEAST_SHARE, Math.min(1 - LEAST_SHARE, t)));
            if (3 * vertices + 3 > positions.length) {
                positions = Arrays.copyOf(positions, 2 * positions.length);
            }
            System.arraycopy(r, 0, positions, 3 * vertices, 3);
            cut[key] = vertices++;
        }
        return cut[key];
    }

    private double[] vertex(int v) {
        return Vectors.of(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    }

    /** Adds a triangle, turned so that it looks from the inner grid point to the outer one. */
    private void triangle(int inner, int outer, int a, int b, int c) {
        if (corners + 3 > triangles.length) {
            triangles = Arrays.copyOf(triangles, 2 * triangles.length);
        }
        double[] normal = Vectors.cross(Vectors.minus(vertex(b), vertex(a)), Vectors.minus(vertex(c), vertex(a)));
        boolean right = Vectors.dot(normal, Vectors.minus(grid(outer), grid(inner))) > 0;
        triangles[corners] = a;
        triangles[corners + 1] = right ? b : c;
        triangles[corners + 2] = right ? c : b;
        corners += 3;
    }
}
