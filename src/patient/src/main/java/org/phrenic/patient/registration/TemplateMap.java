package org.phrenic.patient.registration;

import org.phrenic.engine.kinematics.RigidMotion;

/**
 * The map of a template to a body: {@code x' = P(A(x) + u(x))} with a symmetric affine transform A, a smooth field u
 * and the rigid motion P from the upright axes of the template to those of the scan.
 *
 * @param pose from upright axes to those of the scan
 * @param affine size and proportions
 * @param field displacements in upright axes at points of the template
 */
record TemplateMap(RigidMotion pose, SymmetricAffine affine, SmoothField field) implements PointTransform {
    private static final SmoothField.Scale[] NO_SCALES = {};

    /** A map without displacements. */
    static TemplateMap of(RigidMotion pose, SymmetricAffine affine) {
        return new TemplateMap(pose, affine, new SmoothField(new PointPairs(), new double[0], NO_SCALES, 0, 0));
    }

    /** A map whose field passes through pairs of template and scan, within their standard deviations. */
    TemplateMap through(PointPairs pairs, SmoothField.Scale[] scales, double mirror, double plane) {
        double[] displacements = pairs.to();
        pose.inverse().apply(displacements);
        double[] placed = pairs.from();
        affine.apply(placed);
        for (int i = 0; i < placed.length; i++) {
            displacements[i] -= placed[i];
        }
        return new TemplateMap(pose, affine, new SmoothField(pairs, displacements, scales, mirror, plane));
    }

    @Override
    public void apply(double[] points) {
        double[] u = field.at(points);
        affine.apply(points);
        for (int i = 0; i < points.length; i++) {
            points[i] += u[i];
        }
        pose.apply(points);
    }
}
