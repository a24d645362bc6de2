package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.Vectors;

/**
 * Meridians of a bowl-shaped surface: lines from its pole on an axis to its border, one every 2 degrees of azimuth.
 * Positions on a meridian are fractions of its length. In each vertical half-plane through the axis the surface must be
 * star-shaped about one point of the axis, the pivot.
 */
public final class Meridians {
    public static final int AZIMUTHS = 180;
    private static final int SAMPLES = 45;

    private final double[][][] line = new double[AZIMUTHS][SAMPLES + 1][];
    private final double meanLength;
    /** Result of the last call; the search for an edge length repeats it. */
    private double[] perimeters = {};

    /**
     * @param surface region that contains the pivot
     * @param pivotZ height of the pivot on the axis
     * @param upward true if the pole lies above the pivot
     * @param border end point of the meridian at each azimuth, on the surface
     */
    public Meridians(ImplicitSurface surface, VerticalAxis axis, double pivotZ, boolean upward, double[][] border) {
        double start = upward ? Math.PI / 2 : -Math.PI / 2;
        for (int i = 0; i < AZIMUTHS; i++) {
            double azimuth = azimuth(i);
            double[] end = border[i];
            double radial = StrictMath.hypot(end[0] - axis.x(end[2]), end[1] - axis.y(end[2]));
            double stop = StrictMath.atan2(end[2] - pivotZ, radial);
            int n = 3 * SAMPLES / 2;
            double[][] points = new double[n + 1][];
            double guess = 60;
            for (int k = 0; k < n; k++) {
                double angle = start + (stop - start) * k / n;
                double cos = k == 0 ? 0 : StrictMath.cos(angle);
                double sin = StrictMath.sin(angle);
                guess = RootFinder.firstOutward(s -> surface.at(axis.point(azimuth, s * cos, pivotZ + s * sin)), guess);
                points[k] = axis.point(azimuth, guess * cos, pivotZ + guess * sin);
            }
            points[n] = end;
            Polyline course = new Polyline(Arrays.asList(points));
            for (int k = 0; k <= SAMPLES; k++) {
                line[i][k] = k == SAMPLES ? end : course.pointAt(course.length() * k / SAMPLES);
            }
        }
        double sum = 0;
        for (double[][] points : line) {
            for (int k = 1; k <= SAMPLES; k++) {
                sum += Vectors.distance(points[k], points[k - 1]);
            }
        }
        meanLength = sum / AZIMUTHS;
    }

    public static double azimuth(int i) {
        return 2 * Math.PI * i / AZIMUTHS;
    }

    /** Closed ring at one fraction of all meridians. */
    double[][] ring(double fraction) {
        double at = fraction * SAMPLES;
        int low = Math.min((int) at, SAMPLES - 1);
        double[][] ring = new double[AZIMUTHS][];
        for (int i = 0; i < AZIMUTHS; i++) {
            ring[i] = Vectors.lerp(line[i][low], line[i][low + 1], at - low);
        }
        return ring;
    }

    double[] pole() {
        return line[0][0];
    }

    /** Mean length of the meridians, mm. */
    double meanLength() {
        return meanLength;
    }

    /**
     * Perimeters of evenly spaced rings from the pole to the border, mm. The array is shared and must not be modified.
     */
    double[] perimeters(int rings) {
        if (perimeters.length != rings) {
            double[] lengths = new double[rings];
            for (int k = 0; k < rings; k++) {
                double[][] ring = ring((k + 1.0) / rings);
                for (int i = 0; i < AZIMUTHS; i++) {
                    lengths[k] += Vectors.distance(ring[i], ring[(i + 1) % AZIMUTHS]);
                }
            }
            perimeters = lengths;
        }
        return perimeters;
    }
}
