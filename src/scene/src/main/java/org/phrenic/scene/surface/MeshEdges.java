package org.phrenic.scene.surface;

import java.util.Arrays;

/** The edges of triangles, each once, in ascending order of their smaller, then their larger vertex. */
public final class MeshEdges {
    private MeshEdges() {}

    /** Pairs of vertices, the smaller first. */
    public static int[] of(int[] triangles) {
        long[] all = sorted(triangles);
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

    /** For each edge of {@link #of}, how many triangles it has. */
    public static int[] triangleCounts(int[] triangles) {
        long[] all = sorted(triangles);
        int[] uses = new int[all.length];
        int count = 0;
        for (int i = 0; i < all.length; i++) {
            if (i == 0 || all[i] != all[i - 1]) {
                count++;
            }
            uses[count - 1]++;
        }
        return Arrays.copyOf(uses, count);
    }

    private static long[] sorted(int[] triangles) {
        long[] all = new long[triangles.length];
        for (int t = 0; t < triangles.length; t += 3) {
            for (int k = 0; k < 3; k++) {
                long a = triangles[t + k];
                long b = triangles[t + (k + 1) % 3];
                all[t + k] = (Math.min(a, b) << 32) | Math.max(a, b);
            }
        }
        Arrays.sort(all);
        return all;
    }
}
