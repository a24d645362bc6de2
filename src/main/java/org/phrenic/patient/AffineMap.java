package org.phrenic.patient;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.phrenic.geometry.RigidMotion;

/** x' = A x + t: found by least squares from pairs of points, with or without the freedom to shear and to stretch one way. */
final class AffineMap implements PointMap {
    /** Three rows of four numbers. */
    private final double[] m;

    AffineMap(double[] rows) {
        m = rows.clone();
    }

    /** Moves the middle of one box to that of another and scales by their sizes, the same in all directions. */
    static AffineMap ofBoxes(double[] from, double[] to) {
        double a = 0;
        double b = 0;
        for (int k = 0; k < 3; k++) {
            a += from[3 + k] - from[k];
            b += to[3 + k] - to[k];
        }
        double scale = b / a;
        double[] rows = new double[12];
        for (int k = 0; k < 3; k++) {
            rows[5 * k] = scale;
            rows[4 * k + 3] = (to[k] + to[3 + k]) / 2 - scale * (from[k] + from[3 + k]) / 2;
        }
        return new AffineMap(rows);
    }

    /** The similarity nearest to the pairs: rotation of {@link RigidMotion#fit}, scale after Umeyama 1991 (doi 10.1109/34.88573). */
    static AffineMap similarity(double[] from, double[] to) {
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
        return new AffineMap(rows);
    }

    /** The affine map nearest to the pairs. */
    static AffineMap affine(double[] from, double[] to) {
        double[] p = centroid(from);
        DMatrixRMaj normal = new DMatrixRMaj(4, 4);
        DMatrixRMaj right = new DMatrixRMaj(4, 3);
        double[] x = new double[4];
        for (int i = 0; i < from.length; i += 3) {
            for (int k = 0; k < 3; k++) {
                x[k] = from[i + k] - p[k];
            }
            x[3] = 1;
            for (int a = 0; a < 4; a++) {
                for (int b = 0; b < 4; b++) {
                    normal.add(a, b, x[a] * x[b]);
                }
                for (int row = 0; row < 3; row++) {
                    right.add(a, row, x[a] * to[i + row]);
                }
            }
        }
        DMatrixRMaj solution = new DMatrixRMaj(4, 3);
        if (!CommonOps_DDRM.solve(normal, right, solution)) {
            return similarity(from, to);
        }
        double[] rows = new double[12];
        for (int row = 0; row < 3; row++) {
            rows[4 * row + 3] = solution.get(3, row);
            for (int k = 0; k < 3; k++) {
                rows[4 * row + k] = solution.get(k, row);
                rows[4 * row + 3] -= solution.get(k, row) * p[k];
            }
        }
        return new AffineMap(rows);
    }

    private static double[] centroid(double[] points) {
        double[] c = new double[3];
        for (int i = 0; i < points.length; i++) {
            c[i % 3] += points[i] * 3 / points.length;
        }
        return c;
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
