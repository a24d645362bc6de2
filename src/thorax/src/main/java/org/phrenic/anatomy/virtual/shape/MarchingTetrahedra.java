package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;

/**
 * Triangulates an implicit surface by marching tetrahedra. Each grid cube is split into six tetrahedra along its
 * diagonal (Kuhn subdivision); each cut tetrahedron yields one or two triangles. The mesh is closed and manifold if the
 * region lies inside the grid.
 */
public final class MarchingTetrahedra {
    /** The six paths from corner 0 to corner 7 of a cube (bits: x 1, y 2, z 4). */
    private static final int[][] TETRAHEDRA = {
        {0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}
    };

    /** For each number of inside corners, the cut edges as (inner, outer) corners in order around the cut. */
    private static final int[][][] CUTS = {
        {}, {{0, 0}, {0, 1}, {0, 2}}, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {{0, 0}, {1, 0}, {2, 0}}, {}
    };

    /** Least distance of a cut from a corner, as a fraction of the edge, against needle triangles. */
    private static final double MIN_CUT_SHARE = 0.12;

    private final int[] size = new int[3];
    private final double[] origin;
    private final double step;
    private final double[] value;
    /** Vertex on each of the seven edges up from each grid point, indexed by edge bits less one; -1 if none. */
    private final int[] cut;

    /** Grid points of the current cube. */
    private final int[] corner = new int[8];

    private final int[] insideCorners = new int[4];
    private final int[] outsideCorners = new int[4];
    private final int[] corners = new int[4];
    private final double[] normal = new double[3];
    private double[] positions = new double[3 * 1024];
    private int vertices;
    private int[] triangles = new int[3 * 2048];
    private int length;

    private MarchingTetrahedra(ImplicitSurface field, double[] low, double[] high, double step) {
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

    /** Triangulates the surface within a box, with a grid step of {@code step} mm. */
    public static TriangleMesh surface(ImplicitSurface field, double[] low, double[] high, double step) {
        MarchingTetrahedra march = new MarchingTetrahedra(field, low, high, step);
        for (int k = 0; k < march.size[2] - 1; k++) {
            for (int j = 0; j < march.size[1] - 1; j++) {
                for (int i = 0; i < march.size[0] - 1; i++) {
                    if (march.isCut(i, j, k)) {
                        march.cube(i, j, k);
                    }
                }
            }
        }
        return new TriangleMesh(
                Arrays.copyOf(march.positions, 3 * march.vertices), Arrays.copyOf(march.triangles, march.length));
    }

    private int index(int i, int j, int k) {
        return (k * size[1] + j) * size[0] + i;
    }

    /** True if the cube has corners inside and outside the region. */
    private boolean isCut(int i, int j, int k) {
        int inside = 0;
        for (int c = 0; c < 8; c++) {
            inside += value[index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))] < 0 ? 1 : 0;
        }
        return inside % 8 != 0;
    }

    private void cube(int i, int j, int k) {
        for (int c = 0; c < 8; c++) {
            corner[c] = index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
        }
        for (int[] t : TETRAHEDRA) {
            tetrahedron(i, j, k, t);
        }
    }

    private void tetrahedron(int i, int j, int k, int[] tetrahedron) {
        int inside = 0;
        int outside = 0;
        for (int c : tetrahedron) {
            if (value[corner[c]] < 0) {
                insideCorners[inside++] = c;
            } else {
                outsideCorners[outside++] = c;
            }
        }
        int[][] pairs = CUTS[inside];
        for (int n = 0; n < pairs.length; n++) {
            corners[n] = cut(i, j, k, insideCorners[pairs[n][0]], outsideCorners[pairs[n][1]]);
        }
        if (pairs.length >= 3) {
            addTriangle(corners[0], corners[1], corners[2]);
        }
        if (pairs.length == 4) {
            addTriangle(corners[0], corners[2], corners[3]);
        }
    }

    /** Vertex on the edge between two cube corners; the bits of one corner contain those of the other. */
    private int cut(int i, int j, int k, int one, int other) {
        int low = Math.min(one, other);
        int high = Math.max(one, other);
        int key = 7 * corner[low] + high - low - 1;
        if (cut[key] < 0) {
            double below = value[corner[low]];
            double t = Math.max(MIN_CUT_SHARE, Math.min(1 - MIN_CUT_SHARE, below / (below - value[corner[high]])));
            if (3 * vertices + 3 > positions.length) {
                positions = Arrays.copyOf(positions, 2 * positions.length);
            }
            positions[3 * vertices] = between(0, i, low & 1, high & 1, t);
            positions[3 * vertices + 1] = between(1, j, low >> 1 & 1, high >> 1 & 1, t);
            positions[3 * vertices + 2] = between(2, k, low >> 2, high >> 2, t);
            cut[key] = vertices++;
        }
        return cut[key];
    }

    private double between(int axis, int cube, int low, int high, double t) {
        double p = origin[axis] + (cube + low) * step;
        return p + t * (origin[axis] + (cube + high) * step - p);
    }

    /** Component along an axis of the offset from the first inner to the first outer corner, -1 to 1. */
    private double outward(int axis) {
        return (outsideCorners[0] >> axis & 1) - (insideCorners[0] >> axis & 1);
    }

    /** Adds a triangle, oriented from the inner to the outer corners. */
    private void addTriangle(int a, int b, int c) {
        if (length + 3 > triangles.length) {
            triangles = Arrays.copyOf(triangles, 2 * triangles.length);
        }
        Triangles.cross(positions, 3 * a, 3 * b, 3 * c, normal);
        boolean right = normal[0] * outward(0) + normal[1] * outward(1) + normal[2] * outward(2) > 0;
        triangles[length] = a;
        triangles[length + 1] = right ? b : c;
        triangles[length + 2] = right ? c : b;
        length += 3;
    }
}
