package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.cage.RibCourse;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.PlaneCut;

/**
 * Posterior end of what a scan shows of a rib: the straight line through the middles of its last cross-sections.
 *
 * @param end where the line leaves the rib, LPS, mm
 * @param direction unit vector along the line, from the end into the rib
 */
record RibStump(double[] end, double[] direction) {
    /** Path of the first section; an oblique end leaves it whole, mm. */
    private static final double FIRST_MM = 4;

    private static final double LAST_MM = 14;
    private static final double STEP_MM = 2;
    private static final int ROUNDS = 3;
    /** Sections farther than this from the line belong to another part of the rib, mm. */
    private static final double REACH_MM = 12;

    static RibStump of(TriangleMesh rib, RibCourse course) {
        double[] at = course.at((FIRST_MM + LAST_MM) / 2);
        double[] direction = Vectors.normalize(Vectors.subtract(course.at(LAST_MM), course.at(FIRST_MM)));
        for (int round = 0; round < ROUNDS; round++) {
            List<double[]> middles = new ArrayList<>();
            double half = (LAST_MM - FIRST_MM) / 2;
            for (double s = -half; s <= half; s += STEP_MM) {
                middle(rib, Vectors.addScaled(at, direction, s), direction).ifPresent(middles::add);
            }
            if (middles.size() < 3) {
                break;
            }
            at = mean(middles);
            direction = slope(middles, at);
        }
        double back = Vectors.dot(Vectors.subtract(course.at(0), at), direction);
        return new RibStump(Vectors.addScaled(at, direction, back), direction);
    }

    /** Middle of the area of the cross-section at a point. */
    private static Optional<double[]> middle(TriangleMesh rib, double[] at, double[] normal) {
        double[] across = Vectors.orthonormalize(
                Math.abs(normal[2]) < 0.9 ? new double[] {0, 0, 1} : new double[] {1, 0, 0}, normal);
        double[] upward = Vectors.cross(normal, across);
        double[] best = null;
        double nearest = REACH_MM;
        for (double[] curve : new PlaneCut(at, across, upward).intersect(rib.positions(), rib.triangles())) {
            double area = 0;
            double x = 0;
            double y = 0;
            for (int i = 0; i + 3 < curve.length; i += 2) {
                double part = curve[i] * curve[i + 3] - curve[i + 2] * curve[i + 1];
                area += part;
                x += part * (curve[i] + curve[i + 2]) / 3;
                y += part * (curve[i + 1] + curve[i + 3]) / 3;
            }
            double distance = StrictMath.hypot(x / area, y / area);
            if (distance < nearest) {
                nearest = distance;
                best = Vectors.addScaled(Vectors.addScaled(at, across, x / area), upward, y / area);
            }
        }
        return Optional.ofNullable(best);
    }

    private static double[] mean(List<double[]> points) {
        double[] c = new double[3];
        for (double[] p : points) {
            c = Vectors.addScaled(c, p, 1.0 / points.size());
        }
        return c;
    }

    /** Direction of the regression of points over their order. */
    private static double[] slope(List<double[]> points, double[] mean) {
        double[] d = new double[3];
        for (int i = 0; i < points.size(); i++) {
            d = Vectors.addScaled(d, Vectors.subtract(points.get(i), mean), i - (points.size() - 1) / 2.0);
        }
        return Vectors.normalize(d);
    }
}
