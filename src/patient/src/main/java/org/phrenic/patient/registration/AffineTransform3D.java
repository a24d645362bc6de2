package org.phrenic.patient.registration;

import org.phrenic.engine.kinematics.RigidMotion;

/** An affine transform {@code x' = A x + t}, fitted to point pairs by least squares. */
final class AffineTransform3D implements PointTransform {
    /** The 3 x 4 matrix [A t] in row-major order. */
    private final double[] m;

    private AffineTransform3D(double[] rows) {
        m = rows;
    }

    /**
     * Best fitting similarity: rotation from {@link RigidMotion#fit}, scale after Umeyama 1991 (doi 10.1109/34.88573).
     */
    static AffineTransform3D similarity(double[] from, double[] to) {
        RigidMotion turn = RigidMotion.fit(from, to);
        double[] p = centroid(from);
        double[] q = centroid(to);
        double along = 0;
        double square = 0;
        for (int i = 0; i < from.length; i += 3) {
            for (int row = 0; row < 3; row++) {
                double turned = 0;
                for (int k = 0; k < 3; k++) {
                    turned += turn.rotation(row, k) * (from[i + k] - p[k]);
                }
                along += turned * (to[i + row] - q[row]);
                square += turned * turned;
            }
        }
        double scale = along / square;
        double[] rows = new double[12];
        for (int row = 0; row < 3; row++) {
            rows[4 * row + 3] = q[row];
            for (int k = 0; k < 3; k++) {
                rows[4 * row + k] = scale * turn.rotation(row, k);
                rows[4 * row + 3] -= rows[4 * row + k] * p[k];
            }
        }
        return new AffineTransform3D(rows);
    }

    private static double[] centroid(double[] points) {
        double[] c = new double[3];
        for (int i = 0; i < points.length; i++) {
            c[i % 3] += points[i] * 3 / points.length;
        }
        return c;
    }

    /** Scale of a similarity. */
    double scale() {
        return StrictMath.cbrt(m[0] * (m[5] * m[10] - m[6] * m[9])
                - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8]));
    }

    /** Rotation angle of a similarity, degrees. */
    double turnDeg() {
        double cosine = ((m[0] + m[5] + m[10]) / scale() - 1) / 2;
        return Math.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
    }

    @Override
    public void apply(double[] points) {
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i];
            double y = points[i + 1];
            double z = points[i + 2];
            for (int row = 0; row < 3; row++) {
                points[i + row] = m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z + m[4 * row + 3];
            }
        }
    }
}
