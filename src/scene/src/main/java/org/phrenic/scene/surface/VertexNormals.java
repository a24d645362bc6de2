package org.phrenic.scene.surface;

import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * Smooth vertex normals: the area-weighted sum of the normals of the adjacent triangles. Packed into signed ten-bit
 * components in the format {@code GL_INT_2_10_10_10_REV}.
 */
public final class VertexNormals {
    private static final float MAX_COMPONENT = 511;
    private static final int TEN_BITS = 0x3ff;

    private final int[] triangles;
    private final float[] sum;

    public VertexNormals(int[] triangles, int vertices) {
        this.triangles = triangles;
        sum = new float[3 * vertices];
    }

    /**
     * Computes the normals.
     *
     * @param p vertex positions, x y z each, mm
     * @param packed receives one packed normal per vertex
     */
    public void compute(float[] p, IntBuffer packed) {
        Arrays.fill(sum, 0);
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            float ax = p[a];
            float ay = p[a + 1];
            float az = p[a + 2];
            float ux = p[b] - ax;
            float uy = p[b + 1] - ay;
            float uz = p[b + 2] - az;
            float vx = p[c] - ax;
            float vy = p[c + 1] - ay;
            float vz = p[c + 2] - az;
            float nx = uy * vz - uz * vy;
            float ny = uz * vx - ux * vz;
            float nz = ux * vy - uy * vx;
            add(a, nx, ny, nz);
            add(b, nx, ny, nz);
            add(c, nx, ny, nz);
        }
        for (int i = 0; i < sum.length; i += 3) {
            float x = sum[i];
            float y = sum[i + 1];
            float z = sum[i + 2];
            float squared = x * x + y * y + z * z;
            float scale = squared > 0 ? MAX_COMPONENT / (float) Math.sqrt(squared) : 0;
            packed.put(
                    i / 3,
                    (Math.round(x * scale) & TEN_BITS)
                            | ((Math.round(y * scale) & TEN_BITS) << 10)
                            | ((Math.round(z * scale) & TEN_BITS) << 20));
        }
    }

    private void add(int at, float x, float y, float z) {
        sum[at] += x;
        sum[at + 1] += y;
        sum[at + 2] += z;
    }

    /** The last computed normal of a vertex; not of unit length. */
    void normal(int vertex, double[] n) {
        for (int i = 0; i < 3; i++) {
            n[i] = sum[3 * vertex + i];
        }
    }
}
