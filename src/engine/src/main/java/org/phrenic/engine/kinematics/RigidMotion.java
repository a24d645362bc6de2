package org.phrenic.engine.kinematics;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.SingularValueDecomposition_F64;

/**
 * A rigid motion {@code x' = R x + t}: a proper rotation (3 x 3) and a translation (mm). Immutable.
 *
 * <p>{@link #fit} finds the motion that best maps one set of points onto another, {@code min sum |R p_i + t - q_i|^2}.
 * With both sets centred and {@code H = sum p_i q_i^T = U S V^T}, {@code R = V diag(1, 1, det(V U^T)) U^T} and {@code t
 * = q_mean - R p_mean} (K. S. Arun, T. S. Huang, S. D. Blostein 1987, doi 10.1109/TPAMI.1987.4767965; sign of the
 * determinant after I. Soederkvist, P.-A. Wedin 1993, doi 10.1016/0021-9290(93)90098-Y).
 */
public final class RigidMotion {
    /** Tolerance of each entry of {@code R^T R - I}: some thousand rounding errors. */
    private static final double ORTHONORMAL_TOLERANCE = 1e-9;

    /**
     * Distance from a line, relative to the extent, below which points are collinear and leave the rotation
     * undetermined.
     */
    private static final double COLLINEAR_TOLERANCE = 1e-7;

    private static final RigidMotion IDENTITY =
            new RigidMotion(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, new double[] {0, 0, 0});

    private final double[] r;
    private final double[] t;

    private RigidMotion(double[] r, double[] t) {
        this.r = r;
        this.t = t;
    }

    /** The identity. */
    public static RigidMotion identity() {
        return IDENTITY;
    }

    /**
     * Creates a motion from a rotation and a translation.
     *
     * @param rotation 9 numbers, row by row
     * @param translation 3 numbers, mm
     * @throws IllegalArgumentException if the rotation is not a proper rotation or a number is not finite
     */
    public static RigidMotion of(double[] rotation, double[] translation) {
        if (rotation.length != 9 || translation.length != 3) {
            throw new IllegalArgumentException("rigid motion: " + rotation.length + " and " + translation.length
                    + " numbers, expected 9 of a rotation and 3 of a translation");
        }
        for (double value : translation) {
            if (!Double.isFinite(value)) {
                throw new IllegalArgumentException("rigid motion: translation holds " + value + ", expected numbers");
            }
        }
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                double dot = 0;
                for (int k = 0; k < 3; k++) {
                    dot += rotation[3 * k + i] * rotation[3 * k + j];
                }
                // The negated comparison also rejects NaN.
                if (!(Math.abs(dot - (i == j ? 1 : 0)) <= ORTHONORMAL_TOLERANCE)) {
                    throw new IllegalArgumentException(
                            "rigid motion: columns " + i + " and " + j + " of the rotation have the product " + dot
                                    + ", expected " + (i == j ? 1 : 0) + " of an orthonormal matrix");
                }
            }
        }
        if (determinant(rotation) < 0) {
            throw new IllegalArgumentException("rigid motion: a reflection (determinant -1), expected a rotation");
        }
        return new RigidMotion(rotation.clone(), translation.clone());
    }

    /** The translation by {@code (x, y, z)} mm. */
    public static RigidMotion translation(double x, double y, double z) {
        return of(IDENTITY.r, new double[] {x, y, z});
    }

    /**
     * The least-squares motion from one set of points to another.
     *
     * @param from x, y, z of each point, mm
     * @param to corresponding points in the same order, mm
     * @throws IllegalArgumentException for fewer than 3 points, different counts, collinear points, or a NaN
     */
    public static RigidMotion fit(double[] from, double[] to) {
        if (from.length != to.length || from.length % 3 != 0) {
            throw new IllegalArgumentException("rigid fit: " + from.length + " and " + to.length
                    + " coordinates, expected the same multiple of 3 in both");
        }
        if (from.length < 9) {
            throw new IllegalArgumentException("rigid fit: " + from.length / 3 + " points, expected at least 3");
        }
        double[] p = centroid(from, "from");
        double[] q = centroid(to, "to");
        requireSpread(from, p, "from");
        requireSpread(to, q, "to");

        DMatrixRMaj h = new DMatrixRMaj(3, 3);
        for (int n = 0; n < from.length; n += 3) {
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    h.add(i, j, (from[n + i] - p[i]) * (to[n + j] - q[j]));
                }
            }
        }
        SingularValueDecomposition_F64<DMatrixRMaj> svd = DecompositionFactory_DDRM.svd(3, 3, true, true, false);
        if (!svd.decompose(h)) {
            throw new IllegalArgumentException("rigid fit: the singular values of the points were not found");
        }
        DMatrixRMaj u = svd.getU(null, false);
        DMatrixRMaj v = svd.getV(null, false);
        // EJML does not sort singular values. A reflection is removed by flipping the direction of the smallest one.
        double[] s = svd.getSingularValues();
        int smallest = s[0] <= s[1] && s[0] <= s[2] ? 0 : s[1] <= s[2] ? 1 : 2;
        DMatrixRMaj rotation = new DMatrixRMaj(3, 3);
        CommonOps_DDRM.multTransB(v, u, rotation);
        if (determinant(rotation.data) < 0) {
            for (int i = 0; i < 3; i++) {
                v.set(i, smallest, -v.get(i, smallest));
            }
            CommonOps_DDRM.multTransB(v, u, rotation);
        }
        double[] r = rotation.data;
        double[] t = new double[3];
        for (int i = 0; i < 3; i++) {
            t[i] = q[i] - (r[3 * i] * p[0] + r[3 * i + 1] * p[1] + r[3 * i + 2] * p[2]);
        }
        return new RigidMotion(r.clone(), t);
    }

    /** Entry of the rotation matrix; row and column from 0. */
    public double rotation(int row, int column) {
        return r[3 * row + column];
    }

    /** Component of the translation in mm: 0 x, 1 y, 2 z. */
    public double translation(int axis) {
        return t[axis];
    }

    /** The transformed point {@code {x, y, z}}, mm. */
    public double[] apply(double x, double y, double z) {
        double[] point = {x, y, z};
        apply(point);
        return point;
    }

    /** Transforms all points of an array (x, y, z in turn, mm) in place. */
    public void apply(double[] points) {
        for (int n = 0; n + 2 < points.length; n += 3) {
            double x = points[n];
            double y = points[n + 1];
            double z = points[n + 2];
            points[n] = r[0] * x + r[1] * y + r[2] * z + t[0];
            points[n + 1] = r[3] * x + r[4] * y + r[5] * z + t[1];
            points[n + 2] = r[6] * x + r[7] * y + r[8] * z + t[2];
        }
    }

    /** The composition: {@code first}, then this motion. */
    public RigidMotion after(RigidMotion first) {
        double[] product = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                product[3 * i + j] =
                        r[3 * i] * first.r[j] + r[3 * i + 1] * first.r[3 + j] + r[3 * i + 2] * first.r[6 + j];
            }
        }
        return new RigidMotion(product, apply(first.t[0], first.t[1], first.t[2]));
    }

    /** The inverse motion. */
    public RigidMotion inverse() {
        double[] back = {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
        RigidMotion turn = new RigidMotion(back, new double[3]);
        return new RigidMotion(back, turn.apply(-t[0], -t[1], -t[2]));
    }

    /** Root mean square distance between the transformed {@code from} and {@code to}, mm. */
    public double rms(double[] from, double[] to) {
        double[] moved = from.clone();
        apply(moved);
        double sum = 0;
        for (int i = 0; i < moved.length; i++) {
            sum += (moved[i] - to[i]) * (moved[i] - to[i]);
        }
        return Math.sqrt(3 * sum / moved.length);
    }

    private static double determinant(double[] m) {
        return m[0] * (m[4] * m[8] - m[5] * m[7])
                - m[1] * (m[3] * m[8] - m[5] * m[6])
                + m[2] * (m[3] * m[7] - m[4] * m[6]);
    }

    private static double[] centroid(double[] points, String name) {
        double[] sum = new double[3];
        for (int i = 0; i < points.length; i++) {
            if (!Double.isFinite(points[i])) {
                throw new IllegalArgumentException("rigid fit: point " + i / 3 + " of '" + name + "' holds " + points[i]
                        + ", expected finite coordinates");
            }
            sum[i % 3] += points[i];
        }
        int count = points.length / 3;
        return new double[] {sum[0] / count, sum[1] / count, sum[2] / count};
    }

    /**
     * Rejects collinear points. The line runs from the mean to the farthest point; the other points are compared with
     * it.
     */
    private static void requireSpread(double[] points, double[] mean, String name) {
        double length = 0;
        double[] line = new double[3];
        for (int n = 0; n < points.length; n += 3) {
            double distance = norm(points[n] - mean[0], points[n + 1] - mean[1], points[n + 2] - mean[2]);
            if (distance > length) {
                length = distance;
                for (int i = 0; i < 3; i++) {
                    line[i] = (points[n + i] - mean[i]) / distance;
                }
            }
        }
        double width = 0;
        for (int n = 0; n < points.length; n += 3) {
            double x = points[n] - mean[0];
            double y = points[n + 1] - mean[1];
            double z = points[n + 2] - mean[2];
            width = Math.max(
                    width, norm(y * line[2] - z * line[1], z * line[0] - x * line[2], x * line[1] - y * line[0]));
        }
        if (width <= COLLINEAR_TOLERANCE * length) {
            throw new IllegalArgumentException("rigid fit: the " + points.length / 3 + " points of '" + name
                    + "' lie on one line, expected at least 3 that do not");
        }
    }

    private static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
