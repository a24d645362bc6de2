package org.phrenic.patient.registration;

import org.phrenic.anatomy.cage.RibCourse;
import org.phrenic.mesh.Vectors;

/**
 * Course of a rib from its joint with the spine to the posterior end of what the scan shows of it.
 *
 * <p>Two estimates of the head are joined with weights {@code 1 / sigma^2}: the template's as its vertebra carries it,
 * sigma 5 mm, and the template's neck attached to the end of the scan's rib in the direction of that, sigma 2 mm and a
 * fifth of the neck's length. The joint then settles the place ({@link CostovertebralJoint}).
 *
 * @param course from the head; x, y, z in turn, mm
 * @param lengthMm length that the scan's rib lacks
 */
record RibNeck(double[] course, double lengthMm) {
    private static final int ROUNDS = 4;
    /** Part of the rib before the end whose direction counts, mm. */
    private static final double DIRECTION_MM = 20;

    /** Path of the first section that an oblique end leaves whole, mm. */
    private static final double SECTION_MM = 8;

    private static final double SPINE_SIGMA_MM = 5;
    private static final double RIB_SIGMA_MM = 2;
    private static final double RIB_SIGMA_PER_MM = 0.2;
    /** Longest neck looked for, mm. */
    private static final int REACH_MM = 60;

    /** @param spine places the template at the vertebra of the rib */
    static RibNeck of(RibCourse template, PointTransform spine, RibCourse scan, CostovertebralJoint joint) {
        int n = REACH_MM + 2 * (int) (SECTION_MM + DIRECTION_MM);
        double[] line = new double[3 * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(template.at(i), 0, line, 3 * i, 3);
        }
        spine.apply(line);
        double step = Vectors.distance(point(line, 0), point(line, REACH_MM))
                / Vectors.distance(template.at(0), template.at(REACH_MM));
        // The end of a wide rib is the mean of a corner; its middle lies on the line of the sections before it.
        double[] before = scan.at(SECTION_MM);
        double[] direction = direction(before, scan.at(SECTION_MM + DIRECTION_MM));
        double[] end =
                Vectors.addScaled(before, direction, Vectors.dot(Vectors.subtract(scan.at(0), before), direction));
        double along = nearest(line, end);
        double[] head = point(line, 0);
        int at = 0;
        for (int round = 0; round < ROUNDS; round++) {
            at = (int) Math.max(0, Math.min(REACH_MM, Math.round(along)));
            double[] section = point(line, (int) (at + SECTION_MM / step));
            double[] own = direction(section, point(line, (int) (at + (SECTION_MM + DIRECTION_MM) / step)));
            double[] attached =
                    Vectors.addScaled(before, turned(own, direction, Vectors.subtract(point(line, 0), section)), 1);
            double sigma = RIB_SIGMA_MM + RIB_SIGMA_PER_MM * at * step;
            double weight = 1 / (sigma * sigma);
            head = joint.settle(
                    Vectors.lerp(point(line, 0), attached, weight / (weight + 1 / (SPINE_SIGMA_MM * SPINE_SIGMA_MM))));
            double chord = Vectors.distance(point(line, 0), point(line, at)) / Math.max(1, at);
            double[] neck = turned(own, direction, direction(point(line, 0), point(line, Math.max(at, 8))));
            double distance = Vectors.dot(Vectors.subtract(end, head), neck);
            along = (along + Math.max(0, distance) / Math.max(0.5, chord)) / 2;
        }
        return between(line, at, head, end);
    }

    /** The template's neck, shifted at its ends to the head and to the end of the scan's rib. */
    private static RibNeck between(double[] line, int at, double[] head, double[] end) {
        double[] course = new double[3 * at + 3];
        double length = 0;
        for (int i = 0; i <= at; i++) {
            double t = at == 0 ? 1 : (double) i / at;
            for (int k = 0; k < 3; k++) {
                course[3 * i + k] = line[3 * i + k] + (1 - t) * (head[k] - line[k]) + t * (end[k] - line[3 * at + k]);
            }
            length += i == 0 ? 0 : Math.sqrt(Vectors.squaredDistance(course, i - 1, i));
        }
        return new RibNeck(course, length);
    }

    private static double[] point(double[] line, int i) {
        int at = Math.min(i, line.length / 3 - 1);
        return new double[] {line[3 * at], line[3 * at + 1], line[3 * at + 2]};
    }

    private static double[] direction(double[] from, double[] to) {
        return Vectors.normalize(Vectors.subtract(to, from));
    }

    private static int nearest(double[] line, double[] p) {
        int best = 0;
        for (int i = 1; i <= REACH_MM; i++) {
            if (Vectors.distance(point(line, i), p) < Vectors.distance(point(line, best), p)) {
                best = i;
            }
        }
        return best;
    }

    /** Turns a vector by the smallest rotation that brings one direction to another. */
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
