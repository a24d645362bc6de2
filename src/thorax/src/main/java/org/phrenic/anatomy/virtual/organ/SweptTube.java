package org.phrenic.anatomy.virtual.organ;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.TaperedCapsule;
import org.phrenic.mesh.Vectors;

/**
 * A tube of varying radius with round ends along a smooth curve through given points: a chain of tapered capsules.
 * Coordinates and radius are monotone cubic curves of the length of the polygon through the points.
 */
final class SweptTube implements ImplicitSurface {
    private static final double STEP_MM = 4;
    /** Capsules in a group, which is left out when its bounding ball is farther than what was found. */
    private static final int GROUP = 6;

    private final List<TaperedCapsule> capsules = new ArrayList<>();
    private final List<double[]> points = new ArrayList<>();
    private final double[] balls;

    /** @param rows x, y, z and radius of at least two points */
    SweptTube(List<ImmutableDoubleArray> rows) {
        int n = rows.size();
        double[] path = new double[n];
        for (int i = 1; i < n; i++) {
            path[i] = path[i - 1] + Vectors.distance(place(rows.get(i)), place(rows.get(i - 1)));
        }
        ProfileCurve[] curves = new ProfileCurve[4];
        for (int c = 0; c < 4; c++) {
            int column = c;
            curves[c] = new ProfileCurve(
                    path, rows.stream().mapToDouble(row -> row.at(column)).toArray());
        }
        int steps = Math.max(n, (int) Math.ceil(path[n - 1] / STEP_MM));
        for (int i = 0; i <= steps; i++) {
            double at = path[n - 1] * i / steps;
            points.add(new double[] {curves[0].at(at), curves[1].at(at), curves[2].at(at), curves[3].at(at)});
        }
        for (int i = 0; i < steps; i++) {
            double[] from = points.get(i);
            double[] to = points.get(i + 1);
            capsules.add(new TaperedCapsule(from, to, from[3], to[3]));
        }
        balls = new double[4 * ((steps + GROUP - 1) / GROUP)];
        for (int g = 0; g < balls.length / 4; g++) {
            ball(g, points.subList(g * GROUP, Math.min((g + 1) * GROUP, steps) + 1));
        }
    }

    private static double[] place(ImmutableDoubleArray row) {
        return Vectors.of(row.at(0), row.at(1), row.at(2));
    }

    private void ball(int group, List<double[]> of) {
        double[] middle = of.get(of.size() / 2);
        System.arraycopy(middle, 0, balls, 4 * group, 3);
        for (double[] p : of) {
            balls[4 * group + 3] = Math.max(balls[4 * group + 3], Vectors.distance(middle, p) + p[3]);
        }
    }

    @Override
    public double at(double x, double y, double z) {
        double least = Double.POSITIVE_INFINITY;
        for (int g = 0; g < balls.length / 4; g++) {
            double dx = x - balls[4 * g];
            double dy = y - balls[4 * g + 1];
            double dz = z - balls[4 * g + 2];
            if (Math.sqrt(dx * dx + dy * dy + dz * dz) - balls[4 * g + 3] < least) {
                int end = Math.min((g + 1) * GROUP, capsules.size());
                for (int i = g * GROUP; i < end; i++) {
                    least = Math.min(least, capsules.get(i).at(x, y, z));
                }
            }
        }
        return least;
    }

    /** Extends a box, low corner and high corner, by this tube. */
    void extend(double[] box) {
        for (double[] p : points) {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], p[axis] - p[3]);
                box[3 + axis] = Math.max(box[3 + axis], p[axis] + p[3]);
            }
        }
    }
}
