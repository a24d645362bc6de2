package org.phrenic.access.ultrasound;

import java.util.SplittableRandom;

/**
 * Scatterers of tissue: a fixed complex noise in rest coordinates of mean power 1 everywhere, white on a lattice of
 * {@value #CELL_MM} mm and linearly interpolated between its points, so that it changes smoothly where tissue moves. It
 * repeats after {@value #SIZE} points. What a scanner adds up of it has Rayleigh-distributed amplitudes (fully
 * developed speckle).
 */
final class SpeckleField {
    static final double CELL_MM = 0.4;
    static final int SIZE = 64;
    /** Makes the coordinates of cells positive, so that truncation is rounding down. */
    static final double OFFSET = 1 << 20;

    private static final long SEED = 20240607;
    /** Real and imaginary parts in turn, x fastest. */
    private static final float[] LATTICE = lattice();

    private static final int MASK = SIZE - 1;
    private static final int ROW = 2 * SIZE;
    private static final int LAYER = ROW * SIZE;

    private float real;
    private float imaginary;

    private static float[] lattice() {
        double range = Math.sqrt(1.5);
        float[] values = new float[2 * SIZE * SIZE * SIZE];
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) (range * (2 * random.nextDouble() - 1));
        }
        return values;
    }

    /**
     * Correlation of two places along an axis of the lattice, about: that of linear interpolation, a cubic B-spline.
     *
     * @param distanceMm between them
     */
    static double correlation(double distanceMm) {
        double x = Math.abs(distanceMm) / CELL_MM;
        if (x >= 2) {
            return 0;
        }
        double spline = x < 1 ? 2 / 3.0 - x * x + x * x * x / 2 : (2 - x) * (2 - x) * (2 - x) / 6;
        return 1.5 * spline;
    }

    /** Looks up the noise at a place in units of the lattice, positive. */
    void lookUp(double x, double y, double z) {
        int i = (int) x;
        int j = (int) y;
        int k = (int) z;
        float u = (float) (x - i);
        float v = (float) (y - j);
        float w = (float) (z - k);
        int x0 = (i & MASK) << 1;
        int x1 = (i + 1 & MASK) << 1;
        int y0 = (j & MASK) * ROW;
        int y1 = (j + 1 & MASK) * ROW;
        int z0 = (k & MASK) * LAYER;
        int z1 = (k + 1 & MASK) * LAYER;
        float a = (1 - v) * (1 - w);
        float b = v * (1 - w);
        float c = (1 - v) * w;
        float d = v * w;
        float[] l = LATTICE;
        int p = y0 + z0;
        int q = y1 + z0;
        int r = y0 + z1;
        int s = y1 + z1;
        float low = a * l[p + x0] + b * l[q + x0] + c * l[r + x0] + d * l[s + x0];
        float high = a * l[p + x1] + b * l[q + x1] + c * l[r + x1] + d * l[s + x1];
        // Between lattice points the sum of squared weights is below 1.
        float power = (1 - 2 * u * (1 - u)) * (1 - 2 * v * (1 - v)) * (1 - 2 * w * (1 - w));
        float scale = (float) (1 / Math.sqrt(power));
        real = scale * (low + u * (high - low));
        x0++;
        x1++;
        low = a * l[p + x0] + b * l[q + x0] + c * l[r + x0] + d * l[s + x0];
        high = a * l[p + x1] + b * l[q + x1] + c * l[r + x1] + d * l[s + x1];
        imaginary = scale * (low + u * (high - low));
    }

    float real() {
        return real;
    }

    float imaginary() {
        return imaginary;
    }
}
