package org.phrenic.mesh.query;

import org.phrenic.mesh.Vectors;

/**
 * Motion of points inside a surface, derived from the motion of its vertices. A point is a fixed affine combination of
 * the vertices, {@code x = sum c_i x_i}. The coefficients come from an affine moving least squares fit around the rest
 * position (Schaefer, McPhail and Warren 2006, doi 10.1145/1141911.1141920; weights {@code 1 / (d^2 + e^2)^2} with e =
 * {@value #SOFTENING_MM} mm). The result is exact for affine motion and otherwise follows the nearby surface.
 */
public final class MovingLeastSquares {
    private static final double SOFTENING_MM = 5;

    private MovingLeastSquares() {}

    /**
     * Returns one coefficient per vertex.
     *
     * @param rest vertex positions at rest, as x, y, z triples, mm; they must not lie in a plane
     * @param place rest position of the point, mm
     */
    public static double[] coefficients(double[] rest, double[] place) {
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
        return weights;
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

    /** Position of a point for given vertex positions, as x, y, z triples, mm. */
    public static double[] position(double[] coefficients, double[] positions) {
        double[] at = new double[3];
        for (int i = 0; i < coefficients.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                at[axis] += coefficients[i] * positions[3 * i + axis];
            }
        }
        return at;
    }
}
