package org.phrenic.scene;

/** Normals of vertices as the mean of their triangles' by area, in single precision and without allocation: done once a frame. */
final class SmoothNormals {
    private SmoothNormals() {}

    /**
     * Writes place and normal of each vertex one after the other.
     *
     * @param p places, x, y, z each
     * @param triangles three vertices each
     * @param out six numbers a vertex
     */
    static void interleave(float[] p, int[] triangles, float[] out) {
        int n = p.length / 3;
        for (int i = 0; i < n; i++) {
            out[6 * i] = p[3 * i];
            out[6 * i + 1] = p[3 * i + 1];
            out[6 * i + 2] = p[3 * i + 2];
            out[6 * i + 3] = 0;
            out[6 * i + 4] = 0;
            out[6 * i + 5] = 0;
        }
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            float ux = p[b] - p[a];
            float uy = p[b + 1] - p[a + 1];
            float uz = p[b + 2] - p[a + 2];
            float vx = p[c] - p[a];
            float vy = p[c + 1] - p[a + 1];
            float vz = p[c + 2] - p[a + 2];
            float nx = uy * vz - uz * vy;
            float ny = uz * vx - ux * vz;
            float nz = ux * vy - uy * vx;
            add(out, 2 * a, nx, ny, nz);
            add(out, 2 * b, nx, ny, nz);
            add(out, 2 * c, nx, ny, nz);
        }
        for (int i = 3; i < out.length; i += 6) {
            float x = out[i];
            float y = out[i + 1];
            float z = out[i + 2];
            float scale = 1 / (float) Math.sqrt(Math.max(x * x + y * y + z * z, Float.MIN_NORMAL));
            out[i] = x * scale;
            out[i + 1] = y * scale;
            out[i + 2] = z * scale;
        }
    }

    private static void add(float[] out, int at, float x, float y, float z) {
        out[at + 3] += x;
        out[at + 4] += y;
        out[at + 5] += z;
    }
}
