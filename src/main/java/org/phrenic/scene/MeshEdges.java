package org.phrenic.scene;

import java.util.Arrays;

/** The edges of triangles, each once. */
final class MeshEdges {
    private MeshEdges() {}

    /** Pairs of vertices, the smaller first, in ascending order. */
    static int[] of(int[] triangles) {
        long[] all = new long[triangles.length];
        for (int t = 0; t < triangles.length; t += 3) {
            for (int k = 0; k < 3; k++) {
                long a = triangles[t + k];
                long b = triangles[t + (k + 1) % 3];
                all[t + k] = (Math.min(a, b) << 32) | Math.max(a, b);
            }
        }
        Arrays.sort(all);
        int[] pairs = new int[2 * all.length];
        int count = 0;
        for (int i = 0; i < all.length; i++) {
            if (i == 0 || all[i] != all[i - 1]) {
                pairs[count++] = (int) (all[i] >>> 32);
                pairs[count++] = (int) all[i];
            }
        }
        return Arrays.copyOf(pairs, count);
    }
}
