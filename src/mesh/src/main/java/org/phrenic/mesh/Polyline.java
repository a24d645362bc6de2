package org.phrenic.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/** A densely sampled polyline, parametrised by arc length. */
public final class Polyline {
    private final List<double[]> points;
    private final double[] arcLength;

    /** @param points points in turn; one at the place of the point before it adds nothing */
    public Polyline(List<double[]> points) {
        this.points = IntStream.range(0, points.size())
                .filter(i -> i == 0 || Vectors.distance(points.get(i), points.get(i - 1)) != 0)
                .mapToObj(points::get)
                .toList();
        arcLength = new double[this.points.size()];
        for (int i = 1; i < arcLength.length; i++) {
            arcLength[i] = arcLength[i - 1] + Vectors.distance(this.points.get(i), this.points.get(i - 1));
        }
    }

    /**
     * The polyline through points given as x, y, z in turn.
     *
     * @throws IllegalArgumentException if a coordinate is missing
     */
    public static Polyline of(double[] xyz) {
        if (xyz.length % 3 != 0) {
            throw new IllegalArgumentException(
                    "polyline: found " + xyz.length + " coordinates, expected three for each point");
        }
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(Arrays.copyOfRange(xyz, i, i + 3));
        }
        return new Polyline(points);
    }

    /** Catmull-Rom spline with chord-length knots, sampled at {@code dense} points per span. */
    public static Polyline catmullRom(List<double[]> knots, int dense) {
        int n = knots.size();
        double[] at = new double[n];
        for (int i = 1; i < n; i++) {
            at[i] = at[i - 1] + Vectors.distance(knots.get(i), knots.get(i - 1));
        }
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < n - 1; i++) {
            double h = at[i + 1] - at[i];
            double[] from = tangent(knots, at, i);
            double[] to = tangent(knots, at, i + 1);
            for (int k = 0; k < dense; k++) {
                double u = (double) k / dense;
                double v = 1 - u;
                double[] p = Vectors.lerp(knots.get(i), knots.get(i + 1), u * u * (3 - 2 * u));
                p = Vectors.addScaled(p, from, h * u * v * v);
                points.add(Vectors.addScaled(p, to, -h * u * u * v));
            }
        }
        points.add(knots.get(n - 1));
        return new Polyline(points);
    }

    private static double[] tangent(List<double[]> knots, double[] at, int i) {
        int a = Math.max(i - 1, 0);
        int b = Math.min(i + 1, knots.size() - 1);
        double[] slope = Vectors.subtract(knots.get(b), knots.get(a));
        return Vectors.lerp(Vectors.of(0, 0, 0), slope, 1 / (at[b] - at[a]));
    }

    /** Length, mm. */
    public double length() {
        return arcLength[arcLength.length - 1];
    }

    /** Point at an arc length from the start, mm; beyond an end the line goes on straight. */
    public double[] pointAt(double distance) {
        int low = 0;
        int high = arcLength.length - 1;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (arcLength[middle] <= distance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return Vectors.lerp(
                points.get(low), points.get(high), (distance - arcLength[low]) / (arcLength[high] - arcLength[low]));
    }

    /** Resamples the part between two arc lengths as {@code count} equally spaced points. */
    public Polyline resample(double from, double to, int count) {
        List<double[]> piece = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            piece.add(pointAt(from + (to - from) * i / (count - 1)));
        }
        return new Polyline(piece);
    }

    /** Unit direction at an arc length, averaged over 4 mm. */
    public double[] direction(double distance) {
        double from = Math.max(0, distance - 2);
        double to = Math.min(length(), distance + 2);
        return Vectors.normalize(Vectors.subtract(pointAt(to), pointAt(from)));
    }

    public double[] first() {
        return points.get(0);
    }

    public double[] last() {
        return points.get(points.size() - 1);
    }
}
