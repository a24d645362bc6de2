package org.phrenic.scene.surface;

import java.nio.FloatBuffer;
import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Values of a quantity at each vertex of one surface. The returned array is reused by every method. */
public final class FieldValues {
    private final TriangleMesh rest;
    private final float[] values;
    private final float[] restArea;
    private final float[] area;

    public FieldValues(Surface surface) {
        rest = surface.rest();
        int n = rest.vertexCount();
        values = new float[n];
        area = new float[n];
        restArea = new float[n];
        float[] p = new float[3 * n];
        for (int i = 0; i < p.length; i++) {
            p[i] = (float) rest.positions()[i];
        }
        areas(FloatBuffer.wrap(p), restArea);
    }

    /** Distance of each vertex of a deforming body from its rest position, mm. */
    public float[] displacement(FloatBuffer now) {
        double[] r = rest.positions();
        for (int i = 0; i < values.length; i++) {
            values[i] = length(
                    now.get(3 * i) - r[3 * i], now.get(3 * i + 1) - r[3 * i + 1], now.get(3 * i + 2) - r[3 * i + 2]);
        }
        return values;
    }

    /** Distance of each vertex of a rigid body from its rest position, mm. */
    public float[] displacement(float[] pose) {
        for (int i = 0; i < values.length; i++) {
            double x = rest.x(i);
            double y = rest.y(i);
            double z = rest.z(i);
            values[i] = length(
                    pose[0] * x + pose[1] * y + pose[2] * z + pose[3] - x,
                    pose[4] * x + pose[5] * y + pose[6] * z + pose[7] - y,
                    pose[8] * x + pose[9] * y + pose[10] * z + pose[11] - z);
        }
        return values;
    }

    /** Change of area at each vertex relative to rest, percent: 100 (A / A0 - 1). */
    public float[] areaStrain(FloatBuffer now) {
        areas(now, area);
        for (int i = 0; i < values.length; i++) {
            values[i] = restArea[i] > 0 ? 100 * (area[i] / restArea[i] - 1) : 0;
        }
        return values;
    }

    /** Zero at each vertex. */
    public float[] zeros() {
        Arrays.fill(values, 0);
        return values;
    }

    private static float length(double x, double y, double z) {
        return (float) Math.sqrt(x * x + y * y + z * z);
    }

    /** Twice the sum of the areas of the triangles at each vertex. */
    private void areas(FloatBuffer p, float[] sum) {
        Arrays.fill(sum, 0);
        int[] triangles = rest.triangles();
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            double ux = p.get(b) - p.get(a);
            double uy = p.get(b + 1) - p.get(a + 1);
            double uz = p.get(b + 2) - p.get(a + 2);
            double vx = p.get(c) - p.get(a);
            double vy = p.get(c + 1) - p.get(a + 1);
            double vz = p.get(c + 2) - p.get(a + 2);
            float twice = length(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
            sum[a / 3] += twice;
            sum[b / 3] += twice;
            sum[c / 3] += twice;
        }
    }
}
