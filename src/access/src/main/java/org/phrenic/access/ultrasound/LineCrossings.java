package org.phrenic.access.ultrasound;

import java.util.Arrays;

/**
 * Where each scan line crosses surfaces at one level of the elevation. A code is the index of the surface plus one,
 * negative where the line leaves it, and zero for the open sheet of the diaphragm.
 */
final class LineCrossings {
    private final double[][] depths = new double[SectorGrid.LINES][16];
    private final int[][] codes = new int[SectorGrid.LINES][16];
    private final float[][] cosines = new float[SectorGrid.LINES][16];
    private final float[][] slopes = new float[SectorGrid.LINES][16];
    private final int[] counts = new int[SectorGrid.LINES];

    void clear() {
        Arrays.fill(counts, 0);
    }

    /**
     * Adds a crossing in its place by depth; crossings of equal depth stand in the order of their codes.
     *
     * @param cosine of the angle of incidence
     * @param slope change of the depth per elevation
     */
    void add(int line, double depth, int code, double cosine, double slope) {
        int n = counts[line]++;
        if (n == depths[line].length) {
            depths[line] = Arrays.copyOf(depths[line], 2 * n);
            codes[line] = Arrays.copyOf(codes[line], 2 * n);
            cosines[line] = Arrays.copyOf(cosines[line], 2 * n);
            slopes[line] = Arrays.copyOf(slopes[line], 2 * n);
        }
        double[] d = depths[line];
        int at = n;
        while (at > 0 && (d[at - 1] > depth || (d[at - 1] == depth && codes[line][at - 1] > code))) {
            d[at] = d[at - 1];
            codes[line][at] = codes[line][at - 1];
            cosines[line][at] = cosines[line][at - 1];
            slopes[line][at] = slopes[line][at - 1];
            at--;
        }
        d[at] = depth;
        codes[line][at] = code;
        cosines[line][at] = (float) cosine;
        slopes[line][at] = (float) slope;
    }

    int count(int line) {
        return counts[line];
    }

    /** Depth below the face, mm; negative before it. */
    double depth(int line, int crossing) {
        return depths[line][crossing];
    }

    int code(int line, int crossing) {
        return codes[line][crossing];
    }

    double cosine(int line, int crossing) {
        return cosines[line][crossing];
    }

    double slope(int line, int crossing) {
        return slopes[line][crossing];
    }
}
