package org.phrenic.anatomy.virtual;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.geometry.Vectors;

/** A line through space as points close together; places on it are named by the path from its first point. */
final class Course {
    private final List<double[]> points;
    private final double[] path;

    Course(List<double[]> points) {
        this.points = List.copyOf(points);
        path = new double[points.size()];
        for (int i = 1; i < path.length; i++) {
            path[i] = path[i - 1] + Vectors.distance(points.get(i), points.get(i - 1));
        }
    }

    /** The natural way through a few points: Catmull-Rom with chord-length knots, {@code dense} points a span. */
    static Course through(List<double[]> knots, int dense) {
        int n = knots.size();
        double[] at = new double[n];
        for (int i = 1; i < n; i++) {
            at[i] = at[i - 1] + Vectors.distance(knots.get(i), knots.get(i - 1));
        }
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < n - 1; i++) {
            double h = at[i + 1] - at[i];
            double[] from = slope(knots, at, i);
            double[] to = slope(knots, at, i + 1);
            for (int k = 0; k < dense; k++) {
                double u = (double) k / dense;
                double v = 1 - u;
                double[] p = Vectors.lerp(knots.get(i), knots.get(i + 1), u * u * (3 - 2 * u));
                p = Vectors.add(p, from, h * u * v * v);
                points.add(Vectors.add(p, to, -h * u * u * v));
            }
        }
        points.add(knots.get(n - 1));
        return new Course(points);
    }

    private static double[] slope(List<double[]> knots, double[] at, int i) {
        int a = Math.max(i - 1, 0);
        int b = Math.min(i + 1, knots.size() - 1);
        double[] slope = Vectors.minus(knots.get(b), knots.get(a));
        return Vectors.lerp(Vectors.of(0, 0, 0), slope, 1 / (at[b] - at[a]));
    }

    double length() {
        return path[path.length - 1];
    }

    /** The point at this path from the beginning, mm. */
    double[] at(double distance) {
        int low = 0;
        int high = path.length - 1;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (path[middle] <= distance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return Vectors.lerp(points.get(low), points.get(high), (distance - path[low]) / (path[high] - path[low]));
    }

    /** The piece between two paths, as {@code count} points evenly apart. */
    Course piece(double from, double to, int count) {
        List<double[]> piece = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            piece.add(at(from + (to - from) * i / (count - 1)));
        }
        return new Course(piece);
    }

    /** Unit direction at this path, over 4 mm. */
    double[] direction(double distance) {
        double from = Math.max(0, distance - 2);
        double to = Math.min(length(), distance + 2);
        return Vectors.unit(Vectors.minus(at(to), at(from)));
    }

    double[] first() {
        return points.get(0);
    }

    double[] last() {
        return points.get(points.size() - 1);
    }
}
