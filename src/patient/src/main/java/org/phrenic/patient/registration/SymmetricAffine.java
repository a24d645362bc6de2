package org.phrenic.patient.registration;

import java.util.Arrays;
import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * An affine transform that keeps the symmetry of the body: stretch across the plane {@code x = plane}, which becomes
 * {@code x = 0}, and any affine map within it. {@code x' = a (x - plane)}, {@code (y', z') = B (y, z) + t}.
 */
final class SymmetricAffine implements PointTransform {
    /** Length at which a change of scale is weighed against displacements, mm: half the size of a thorax. */
    private static final double ARM_MM = 150;

    /** Weight of the uniform scale relative to the points. */
    private static final double HOLD = 0.05;
    /** Standard deviation among people of the length of a trunk, relative to that which their scale gives. */
    private static final double PROPORTION_SIGMA = 0.1;
    /** Weight of no shear relative to that of the uniform scale. */
    private static final double SHEAR_HOLD = 10;

    private final double plane;
    private final double across;
    /** The rows y' and z', each with the factors of y, z and 1. */
    private final double[] inPlane;

    /**
     * What a spine tells of the lengths along a body.
     *
     * @param factor length along the body over the template's, between that of the spine and the scale of the body
     * @param certainty variance of that factor without the spine over the one with it
     * @param from place of the spine in the template, mm
     * @param z height of the spine in the upright body, mm
     */
    record Spine(double factor, double certainty, double[] from, double z) {
        /**
         * The factor of least error from the heights of vertebrae, to within their standard deviations, and the scale.
         *
         * @param vertebrae their places in the template, with those in the upright body
         */
        static Spine of(PointPairs vertebrae, double scale) {
            double[] w = vertebrae.weights();
            double[] p = vertebrae.from();
            double[] q = vertebrae.to();
            double[] from = PointPairs.centroid(p, w);
            double[] to = PointPairs.centroid(q, w);
            double prior = 1 / (PROPORTION_SIGMA * scale * PROPORTION_SIGMA * scale);
            double square = prior;
            double product = prior * scale;
            for (int i = 0; i < w.length; i++) {
                double z = p[3 * i + 2] - from[2];
                square += w[i] * z * z;
                product += w[i] * z * (q[3 * i + 2] - to[2]);
            }
            return new Spine(product / square, square / prior, from, to[2]);
        }
    }

    private SymmetricAffine(double plane, double across, double[] inPlane) {
        this.plane = plane;
        this.across = across;
        this.inPlane = inPlane;
    }

    /**
     * Fits by weighted least squares, held to a uniform scale; if a spine is given, the factor along the body is held
     * to its factor and the height is its own.
     *
     * @param p points as x, y, z in turn, mm
     * @param q corresponding points
     * @param scale scale to which the factors are held
     */
    static SymmetricAffine fit(
            double[] p, double[] q, double[] weights, double plane, double scale, Optional<Spine> spine) {
        double[] c = PointPairs.centroid(p, weights);
        double prior = HOLD * Arrays.stream(weights).sum() * ARM_MM * ARM_MM;
        double square = prior;
        double product = prior * scale;
        DMatrixRMaj normal = new DMatrixRMaj(3, 3);
        DMatrixRMaj right = new DMatrixRMaj(3, 2);
        for (int i = 0; i < weights.length; i++) {
            double w = weights[i];
            double x = p[3 * i] - plane;
            square += w * x * x;
            product += w * x * q[3 * i];
            double[] row = {p[3 * i + 1] - c[1], p[3 * i + 2] - c[2], 1};
            for (int a = 0; a < 3; a++) {
                for (int b = 0; b < 3; b++) {
                    normal.add(a, b, w * row[a] * row[b]);
                }
                right.add(a, 0, w * row[a] * q[3 * i + 1]);
                right.add(a, 1, w * row[a] * q[3 * i + 2]);
            }
        }
        double[] inPlane = new double[6];
        for (int component = 0; component < 2; component++) {
            DMatrixRMaj m = normal.copy();
            DMatrixRMaj r = CommonOps_DDRM.extractColumn(right, component, null);
            for (int a = 0; a < 2; a++) {
                m.add(a, a, a == component ? prior : SHEAR_HOLD * prior);
            }
            if (component == 1 && spine.isPresent()) {
                double hold = prior * spine.get().certainty();
                m.add(1, 1, hold - prior);
                r.add(1, 0, hold * spine.get().factor());
            } else {
                r.add(component, 0, prior * scale);
            }
            DMatrixRMaj found = new DMatrixRMaj(3, 1);
            CommonOps_DDRM.solve(m, r, found);
            inPlane[3 * component] = found.get(0);
            inPlane[3 * component + 1] = found.get(1);
            inPlane[3 * component + 2] = found.get(2) - found.get(0) * c[1] - found.get(1) * c[2];
        }
        spine.ifPresent(at -> inPlane[5] = at.z() - inPlane[3] * at.from()[1] - inPlane[4] * at.from()[2]);
        return new SymmetricAffine(plane, product / square, inPlane);
    }

    /** Factors from side to side, from back to front and along the body. */
    double[] factors() {
        return new double[] {across, StrictMath.hypot(inPlane[0], inPlane[3]), StrictMath.hypot(inPlane[1], inPlane[4])
        };
    }

    @Override
    public void apply(double[] points) {
        for (int i = 0; i < points.length; i += 3) {
            double y = points[i + 1];
            double z = points[i + 2];
            points[i] = across * (points[i] - plane);
            points[i + 1] = inPlane[0] * y + inPlane[1] * z + inPlane[2];
            points[i + 2] = inPlane[3] * y + inPlane[4] * z + inPlane[5];
        }
    }
}
