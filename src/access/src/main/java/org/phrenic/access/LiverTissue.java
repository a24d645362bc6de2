package org.phrenic.access;

import org.phrenic.mesh.Vectors;

/**
 * Motion of points inside the liver, derived from the motion of its surface. A point is a fixed affine combination of
 * the surface vertices, {@code x = sum c_i x_i}. The coefficients come from an affine moving least squares fit around
 * the rest position (Schaefer, McPhail and Warren 2006, doi 10.1145/1141911.1141920; weights {@code 1 / (d^2 +
 * e^2)^2}). The result is exact for affine motion and otherwise follows the nearby surface.
 */
public final class LiverTissue {
    private static final double SOFTENING_MM = 5;
    private static final int MAX_ITERATIONS = 60;
    private static final double TOLERANCE_MM = 1e-9;

    private final double[] rest;
    private final MovingStructure liver;

    /** A point of the tissue: rest position (LPS, mm) and one coefficient per liver vertex. */
    public record Point(double[] rest, double[] coefficients) {}

    /** @param anatomy provides the current vertex positions */
    public LiverTissue(MovingAnatomy anatomy) {
        liver = anatomy.liver();
        rest = liver.surface().rest().positions();
    }

    /** Returns the tissue point at a rest position, LPS, mm. */
    public Point pointAtRest(double[] place) {
        int n = rest.length / 3;
        double[] weights = new double[n];
        double sum = 0;
        double[] mean = new double[3];
        for (int i = 0; i < n; i++) {
            double dx = rest[3 * i] - place[0];
            double dy = rest[3 * i + 1] - place[1];
            double dz = rest[3 * i + 2] - place[2];
            double soft = dx * dx + dy * dy + dz * dz + SOFTENING_MM * SOFTENING_MM;
            weights[i] = 1 / (soft * soft);
            sum += weights[i];
            for (int axis = 0; axis < 3; axis++) {
                mean[axis] += weights[i] * rest[3 * i + axis];
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            mean[axis] /= sum;
        }
        double[] m = new double[6];
        for (int i = 0; i < n; i++) {
            double x = rest[3 * i] - mean[0];
            double y = rest[3 * i + 1] - mean[1];
            double z = rest[3 * i + 2] - mean[2];
            m[0] += weights[i] * x * x;
            m[1] += weights[i] * x * y;
            m[2] += weights[i] * x * z;
            m[3] += weights[i] * y * y;
            m[4] += weights[i] * y * z;
            m[5] += weights[i] * z * z;
        }
        double[] slope = solveSymmetric(m, Vectors.subtract(place, mean));
        for (int i = 0; i < n; i++) {
            double reach = 0;
            for (int axis = 0; axis < 3; axis++) {
                reach += slope[axis] * (rest[3 * i + axis] - mean[axis]);
            }
            weights[i] *= 1 / sum + reach;
        }
        return new Point(place.clone(), weights);
    }

    /** Solves the symmetric system M x = b by Cramer's rule. Only the upper triangle of M is given. */
    private static double[] solveSymmetric(double[] m, double[] b) {
        double c0 = m[3] * m[5] - m[4] * m[4];
        double c1 = m[2] * m[4] - m[1] * m[5];
        double c2 = m[1] * m[4] - m[2] * m[3];
        double determinant = m[0] * c0 + m[1] * c1 + m[2] * c2;
        double c3 = m[0] * m[5] - m[2] * m[2];
        double c4 = m[1] * m[2] - m[0] * m[4];
        double c5 = m[0] * m[3] - m[1] * m[1];
        return new double[] {
            (c0 * b[0] + c1 * b[1] + c2 * b[2]) / determinant,
            (c1 * b[0] + c3 * b[1] + c4 * b[2]) / determinant,
            (c2 * b[0] + c4 * b[1] + c5 * b[2]) / determinant
        };
    }

    /** Position of a tissue point in the current frame, LPS, mm. */
    public double[] position(Point point) {
        double[] p = liver.positions();
        double[] at = new double[3];
        for (int i = 0; i < point.coefficients.length; i++) {
            double c = point.coefficients[i];
            at[0] += c * p[3 * i];
            at[1] += c * p[3 * i + 1];
            at[2] += c * p[3 * i + 2];
        }
        return liver.toWorld(at);
    }

    /** Returns the tissue point at a current position. Its rest position is found by fixed-point iteration. */
    public Point pointNowAt(double[] place) {
        Point point = pointAtRest(place);
        for (int i = 0; i < MAX_ITERATIONS; i++) {
            double[] error = Vectors.subtract(place, position(point));
            if (Vectors.length(error) < TOLERANCE_MM) {
                break;
            }
            point = pointAtRest(Vectors.addScaled(point.rest, error, 1));
        }
        return point;
    }
}
