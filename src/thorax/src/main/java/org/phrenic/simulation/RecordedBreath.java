package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;

/**
 * Positions of all nodes at evenly spaced times of the last period of a breath, and what lies between them by cubic
 * (Catmull-Rom) interpolation.
 *
 * <p>The end of the period differs from its beginning by the mismatch {@code m = x(P) - x(0)}. The record is closed by
 * adding {@code (1 - t / P) m}, so that it begins and ends at the end that was reached, toward which the breaths
 * converge. Positions are kept as floats: 0.00003 mm at 400 mm.
 */
final class RecordedBreath {
    private final double periodS;
    private final double intervalS;
    private final List<float[]> samples = new ArrayList<>();
    /** Time within the pattern at which the period begins, s: that of the second sample. */
    private double originS;

    private double[] mismatch = {};

    /**
     * @param firstS time within the pattern of the first sample, s
     * @param periodS period of the pattern, s
     * @param intervalS time between samples, s
     */
    RecordedBreath(double firstS, double periodS, double intervalS) {
        originS = firstS + intervalS;
        this.periodS = periodS;
        this.intervalS = intervalS;
    }

    double periodS() {
        return periodS;
    }

    /** Adds the next sample; the first one is dropped if the others cover the period. */
    void add(double[] positions) {
        float[] sample;
        if (isWhole()) {
            sample = samples.remove(0);
            originS += intervalS;
        } else {
            sample = new float[positions.length];
        }
        for (int i = 0; i < sample.length; i++) {
            sample[i] = (float) positions[i];
        }
        samples.add(sample);
    }

    /** Whether the samples cover the period. */
    private boolean isWhole() {
        return (samples.size() - 3) * intervalS >= periodS;
    }

    /**
     * Closes the record if it covers the period and every coordinate ends it within a tolerance, mm, of where it began;
     * returns whether.
     */
    boolean close(double toleranceMm) {
        if (!isWhole()) {
            return false;
        }
        Curve first = curve(0);
        Curve last = curve(periodS);
        double[] off = new double[samples.get(0).length];
        for (int i = 0; i < off.length; i++) {
            off[i] = last.position(i) - first.position(i);
            if (!(Math.abs(off[i]) <= toleranceMm)) {
                return false;
            }
        }
        mismatch = off;
        return true;
    }

    /** Writes positions and velocities at a time within the pattern, s; the record is closed. */
    void at(double patternS, double[] x, double[] v) {
        double since = (patternS - originS) % periodS;
        double into = since < 0 ? since + periodS : since;
        Curve curve = curve(into);
        double left = 1 - into / periodS;
        for (int i = 0; i < x.length; i++) {
            x[i] = curve.position(i) + left * mismatch[i];
            v[i] = curve.velocity(i) / intervalS - mismatch[i] / periodS;
        }
    }

    /** The curve between the samples about a time after the beginning of the period, s. */
    private Curve curve(double intoS) {
        int at = Math.min(samples.size() - 3, 1 + (int) (intoS / intervalS));
        double share = intoS / intervalS - (at - 1);
        return new Curve(samples.get(at - 1), samples.get(at), samples.get(at + 1), samples.get(at + 2), share);
    }

    /**
     * A Catmull-Rom segment from b to c.
     *
     * @param u share of the way from b to c
     */
    private record Curve(float[] a, float[] b, float[] c, float[] d, double u) {
        double position(int i) {
            return b[i] + u * (slope(i) + u * (square(i) + u * cube(i)));
        }

        /** Derivative by the share of the way. */
        double velocity(int i) {
            return slope(i) + u * (2 * square(i) + u * 3 * cube(i));
        }

        private double slope(int i) {
            return 0.5 * (c[i] - a[i]);
        }

        private double square(int i) {
            return a[i] - 2.5 * b[i] + 2.0 * c[i] - 0.5 * d[i];
        }

        private double cube(int i) {
            return 0.5 * (d[i] - a[i]) + 1.5 * ((double) b[i] - c[i]);
        }
    }
}
