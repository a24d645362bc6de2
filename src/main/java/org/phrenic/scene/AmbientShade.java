package org.phrenic.scene;

import java.util.List;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.simulation.Surface;

/**
 * How open to the sky each vertex lies, from 1 free to 0 buried, worked out once for the shape at rest: the opaque surfaces are strewn into a grid, the grid is blurred, and a vertex is shaded by what stands in
 * front of it, a little way along its normal. A breath moves parts by a few cells, which the eye does not miss; a frame then costs nothing.
 */
final class AmbientShade {
    private static final double CELL_MM = 6;
    private static final int BLURS = 2;
    /** Distances along the normal at which the neighbourhood is felt, mm. */
    private static final double[] REACHES = {9, 20};

    private static final double STRENGTH = 1.15;
    private static final double DARKEST = 0.28;

    private final double[] low = new double[3];
    private final int[] count = new int[3];
    private float[] density;

    /** @param casters surfaces that shade others */
    AmbientShade(List<Surface> casters) {
        double[] high = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
        }
        for (Surface s : casters) {
            double[] box = s.rest().bounds();
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], box[axis] - 6 * CELL_MM);
                high[axis] = Math.max(high[axis], box[axis + 3] + 6 * CELL_MM);
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            count[axis] = casters.isEmpty() ? 1 : (int) Math.ceil((high[axis] - low[axis]) / CELL_MM) + 1;
        }
        density = new float[count[0] * count[1] * count[2]];
        casters.forEach(s -> strew(s.rest()));
        for (int i = 0; i < density.length; i++) {
            density[i] = Math.min(1, density[i]);
        }
        for (int i = 0; i < BLURS; i++) {
            for (int axis = 0; axis < 3; axis++) {
                blur(axis);
            }
        }
    }

    /** Each triangle fills the cells it passes, by its area. */
    private void strew(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        for (int i = 0; i < t.length; i += 3) {
            double[] u = new double[3];
            double[] v = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                u[axis] = p[3 * t[i + 1] + axis] - p[3 * t[i] + axis];
                v[axis] = p[3 * t[i + 2] + axis] - p[3 * t[i] + axis];
            }
            double longest = Math.max(length(u), length(v));
            int parts = Math.max(1, (int) Math.ceil(longest / (0.7 * CELL_MM)));
            double area = 0.5
                    * Math.sqrt(square(u[1] * v[2] - u[2] * v[1])
                            + square(u[2] * v[0] - u[0] * v[2])
                            + square(u[0] * v[1] - u[1] * v[0]));
            float share = (float) (area / (parts * (parts + 1) / 2.0) / (CELL_MM * CELL_MM));
            for (int a = 0; a < parts; a++) {
                for (int b = 0; a + b < parts; b++) {
                    double s = (a + 1 / 3.0) / parts;
                    double r = (b + 1 / 3.0) / parts;
                    int cell = cell(
                            p[3 * t[i]] + s * u[0] + r * v[0],
                            p[3 * t[i] + 1] + s * u[1] + r * v[1],
                            p[3 * t[i] + 2] + s * u[2] + r * v[2]);
                    density[cell] += share;
                }
            }
        }
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    private static double square(double value) {
        return value * value;
    }

    private int cell(double x, double y, double z) {
        int i = clamp((x - low[0]) / CELL_MM, count[0]);
        int j = clamp((y - low[1]) / CELL_MM, count[1]);
        int k = clamp((z - low[2]) / CELL_MM, count[2]);
        return (k * count[1] + j) * count[0] + i;
    }

    private static int clamp(double at, int count) {
        return Math.max(0, Math.min(count - 1, (int) at));
    }

    /** Quarter, half, quarter along one axis. */
    private void blur(int axis) {
        int stride = axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1];
        float[] out = new float[density.length];
        for (int i = 0; i < density.length; i++) {
            int along = i / stride % count[axis];
            float before = along > 0 ? density[i - stride] : 0;
            float after = along < count[axis] - 1 ? density[i + stride] : 0;
            out[i] = 0.25f * before + 0.5f * density[i] + 0.25f * after;
        }
        density = out;
    }

    /** Openness at a place with a unit normal. */
    float at(double x, double y, double z, double nx, double ny, double nz) {
        double covered = 0;
        for (double reach : REACHES) {
            covered += density[cell(x + reach * nx, y + reach * ny, z + reach * nz)];
        }
        return (float) Math.max(DARKEST, 1 - STRENGTH * covered / REACHES.length);
    }
}
