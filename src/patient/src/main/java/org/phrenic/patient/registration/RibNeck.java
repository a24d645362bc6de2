package org.phrenic.patient.registration;

import org.phrenic.mesh.Vectors;

/**
 * Course of a rib from its joint with the spine to the posterior end of what the scan shows of it.
 *
 * <p>The head has two estimates: its place at the vertebrae ({@link CostovertebralJoint}), sigma 3 mm, and the straight
 * continuation of the scan's rib ({@link RibStump}), whose sigma {@code 1 + 0.02 d^2} grows with the distance d (mm) to
 * the joint, as necks bend. They are joined as the mean of a Student distribution, so that a continuation far from the
 * joint counts little.
 *
 * @param course from the head; x, y, z in turn, mm
 * @param lengthMm length that the scan's rib lacks
 * @param gapMm distance by which the scan's rib ends short of the head along its own line
 */
record RibNeck(double[] course, double lengthMm, double gapMm) {
    private static final int ROUNDS = 6;
    private static final double PLACE_SIGMA_MM = 3;
    private static final double RIB_SIGMA_MM = 1;
    /** Half of the curvature of a neck, 1/mm. */
    private static final double BEND = 0.02;

    static RibNeck of(RibStump stump, CostovertebralJoint joint) {
        double[] place = joint.place();
        double missing = Vectors.distance(place, stump.end());
        double sigma = RIB_SIGMA_MM + BEND * missing * missing;
        double variance = sigma * sigma + PLACE_SIGMA_MM * PLACE_SIGMA_MM;
        double[] head = place;
        for (int round = 0; round < ROUNDS; round++) {
            double along = Vectors.dot(Vectors.subtract(stump.end(), head), stump.direction());
            double[] straight = Vectors.addScaled(stump.end(), stump.direction(), -along);
            double[] apart = Vectors.subtract(straight, head);
            double share = PLACE_SIGMA_MM * PLACE_SIGMA_MM / (variance + Vectors.dot(apart, apart));
            head = joint.beside(Vectors.lerp(place, straight, share));
        }
        return curve(head, stump.end(), stump.direction());
    }
    /** The cubic that leaves the end of the scan's rib in its direction and reaches the head without curvature. */
    private static RibNeck curve(double[] head, double[] end, double[] direction) {
        double gap = Math.max(0, Vectors.dot(Vectors.subtract(end, head), direction));
        int n = Math.max(1, (int) Math.round(Vectors.distance(head, end)));
        double[] course = new double[3 * n + 3];
        double length = 0;
        for (int i = 0; i <= n; i++) {
            double u = 1 - (double) i / n;
            for (int k = 0; k < 3; k++) {
                double slope = -gap * direction[k];
                double bend = head[k] - end[k] - slope;
                course[3 * i + k] = end[k] + u * slope + bend * u * u * (3 - u) / 2;
            }
            length += i == 0 ? 0 : Math.sqrt(Vectors.squaredDistance(course, i - 1, i));
        }
        return new RibNeck(course, length, gap);
    }

    /**
     * Turns a vector by the smallest rotation that brings one direction to another; opposite ones leave it as it is.
     */
    static double[] turned(double[] from, double[] to, double[] v) {
        double cosine = Vectors.dot(from, to);
        if (cosine < -0.99) {
            return v;
        }
        double[] axis = Vectors.cross(from, to);
        double[] cross = Vectors.cross(axis, v);
        return Vectors.addScaled(Vectors.addScaled(v, cross, 1), Vectors.cross(axis, cross), 1 / (1 + cosine));
    }
}
