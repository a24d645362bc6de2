package org.phrenic.access;

import org.phrenic.mesh.Vectors;

/**
 * How points within the liver move with its surface. A point's place is a fixed affine combination of the surface's
 * vertices, {@code x = Σ c_i x_i}, with the coefficients of an affine moving least squares fit about its place at rest
 * (Schaefer, McPhail and Warren 2006, doi 10.1145/1141911.1141920; weights {@code 1 / (d² + e²)²}): where the liver
 * moves as a rigid or affine body it is exact, and where it bends it follows the surface that is near.
 */
public final class LiverTissue {
    private static final double SOFT_MM = 5;
    private static final int MOST_TURNS = 60;
    private static final double CLOSE_MM = 1e-9;

    private final double[] rest;
    private final MovingStructure liver;

    /** A point of the tissue: its place at rest and what it is made of. */
    public static final class Point {
        private final double[] rest;
        private final double[] coefficients;

        private Point(double[] rest, double[] coefficients) {
            this.rest = rest;
            this.coefficients = coefficients;
        }

        /** Where it rests, LPS, mm; a copy. */
        public double[] rest() {
            return rest.clone();
        }
    }

    /** @param scene whose liver; places are those of the frame that it took last */
    public LiverTissue(MovingAnatomy scene) {
        liver = scene.liver();
        rest = liver.surface().rest().positions();
    }

    /** The point of the tissue that rests at a place. */
    public Point pointAtRest(double[] place) {
        int n = rest.length / 3;
        double[] weights = new double[n];
        double sum = 0;
        double[] mean = new double[3];
        for (int i = 0; i < n; i++) {
            double dx = rest[3 * i] - place[0];
            double dy = rest[3 * i + 1] - place[1];
            double dz = rest[3 * i + 2] - place[2];
            double soft = dx * dx + dy * dy + dz * dz + SOFT_MM * SOFT_MM;
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

    /** Solves the symmetric M x = b, M given by its upper triangle, by Cramer's rule. */
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

    /** Where a point of the tissue is. */
    public double[] position(Point point) {
        return liver.toWorld(combined(point, liver.positions()));
    }

    private static double[] combined(Point point, double[] p) {
        double[] at = new double[3];
        for (int i = 0; i < point.coefficients.length; i++) {
            double c = point.coefficients[i];
            at[0] += c * p[3 * i];
            at[1] += c * p[3 * i + 1];
            at[2] += c * p[3 * i + 2];
        }
        return at;
    }

    /** The point of the tissue that is at a place now: by correcting a first guess with what it misses by. */
    public Point pointNowAt(double[] place) {
        double[] guess = place.clone();
        Point point = pointAtRest(guess);
        for (int turn = 0; turn < MOST_TURNS; turn++) {
            double[] miss = Vectors.subtract(place, position(point));
            if (Vectors.length(miss) < CLOSE_MM) {
                break;
            }
            guess = Vectors.addScaled(guess, miss, 1);
            point = pointAtRest(guess);
        }
        return point;
    }
}
