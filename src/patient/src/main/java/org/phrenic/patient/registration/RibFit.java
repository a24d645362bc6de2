package org.phrenic.patient.registration;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.cage.RibCourse;

/**
 * Correspondence of a rib of the template to the rib of the scan of the same level and side, along their courses. A rib
 * that the scan cuts, or that ends short of the spine, corresponds to a part of the template's.
 */
final class RibFit {
    private static final double STEP_MM = 9;
    /** Ends nearer than this to the end of the scan, where the scan shows them, are cuts, mm. */
    private static final double CUT_MM = 12;
    /** Larger standard deviation of points found by their nearness, which may slide along the rib, mm. */
    private static final double SLIDING_SIGMA_MM = 4;

    private static final double END_SIGMA_MM = 3;
    private static final double COURSE_SIGMA_MM = 1.5;
    /** Longest neck that is grown onto a rib, mm: the line of a rib's end does not tell how its angle bends. */
    static final double LONGEST_NECK_MM = 60;

    private final SharedStructure shared;
    private final RibCourse rest;
    private final RibCourse scan;
    private final RibStump stump;
    private final boolean posteriorCut;
    private final boolean anteriorCut;
    private final TrackedLine line;
    /** Length of the course that the scan lacks at the spine, mm; NaN until it is known. */
    private double missingMm = Double.NaN;

    private Optional<RibNeck> neck = Optional.empty();

    /** Points of the template's course, original and placed. */
    private static final class TrackedLine {
        final double[] rest;
        double[] placed;

        TrackedLine(double[] rest) {
            this.rest = rest;
            placed = rest;
        }
    }

    RibFit(SharedStructure shared) {
        this.shared = shared;
        rest = RibCourse.of(shared.template(), shared.side());
        scan = RibCourse.of(shared.scan(), shared.side());
        stump = RibStump.of(shared.scan(), scan);
        boolean[] atCut = shared.organ().verticesAtCut(CUT_MM);
        double[] vertices = shared.scan().positions();
        double[] ends = scan.line();
        posteriorCut = atCut[nearest(vertices, ends)];
        anteriorCut = atCut[nearest(vertices, Arrays.copyOfRange(ends, ends.length - 3, ends.length))];
        line = new TrackedLine(resampled(rest));
    }

    private static double[] resampled(RibCourse course) {
        int n = (int) Math.ceil(course.lengthMm() / (STEP_MM / 3)) + 1;
        double[] points = new double[3 * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(course.at(course.lengthMm() * i / (n - 1)), 0, points, 3 * i, 3);
        }
        return points;
    }

    Side side() {
        return shared.side();
    }

    SharedStructure shared() {
        return shared;
    }

    RibCourse scanCourse() {
        return scan;
    }

    double missingMm() {
        return missingMm;
    }

    void place(PointTransform map) {
        line.placed = line.rest.clone();
        map.apply(line.placed);
    }

    /** Course from the head to the posterior end of the scan's rib; x, y, z in turn, mm. */
    double[] neckCourse() {
        return neck.orElseThrow().course();
    }

    /** Posterior end of the scan's rib. */
    RibStump stump() {
        return stump;
    }

    /**
     * Finds the head, and with it how far the scan's rib ends short of it, if the scan does not cut the posterior end.
     */
    void findHead(CostovertebralJoint joint) {
        if (!posteriorCut) {
            neck = Optional.of(RibNeck.of(stump, joint));
        }
    }

    /** Forgets the head, before another fit. */
    void forgetNeck() {
        neck = Optional.empty();
        missingMm = Double.NaN;
    }

    /** Distance by which the scan's rib ends short of the joint along its own line, mm; empty if it is not known. */
    OptionalDouble gapMm() {
        return neck.map(n -> OptionalDouble.of(n.gapMm())).orElse(OptionalDouble.empty());
    }

    /** Decides whether the rib ends short of the spine: by more than a limit. */
    void judge(double limitMm) {
        neck.ifPresent(n -> missingMm = n.gapMm() > limitMm ? n.lengthMm() : 0);
    }

    /** Whether the scan lacks so much of the rib at the spine that its course is the template's. */
    boolean lacksBack() {
        return missingMm > LONGEST_NECK_MM;
    }

    /** Index of the point nearest to another. */
    private static int nearest(double[] points, double[] p) {
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < points.length; i += 3) {
            double dx = points[i] - p[0];
            double dy = points[i + 1] - p[1];
            double dz = points[i + 2] - p[2];
            double squared = dx * dx + dy * dy + dz * dz;
            if (squared < least) {
                least = squared;
                best = i / 3;
            }
        }
        return best;
    }

    /** Pairs of points of both courses. */
    PointPairs pairs() {
        PointPairs pairs = new PointPairs();
        int n = Math.max(2, (int) Math.round(scan.lengthMm() / STEP_MM));
        boolean bothEnds = !anteriorCut && missingMm <= LONGEST_NECK_MM;
        double whole = scan.lengthMm() + missingMm;
        for (int i = 0; i <= n; i++) {
            double path = scan.lengthMm() * i / n;
            double[] p = scan.at(path);
            if (bothEnds) {
                pairs.add(rest.at((missingMm + path) / whole * rest.lengthMm()), p, COURSE_SIGMA_MM);
            } else if (i == n && !anteriorCut) {
                pairs.add(rest.at(rest.lengthMm()), p, END_SIGMA_MM);
            } else {
                int at = 3 * nearest(line.placed, p);
                boolean beyond = at == 0 || at == line.rest.length - 3;
                if (!beyond) {
                    pairs.add(new double[] {line.rest[at], line.rest[at + 1], line.rest[at + 2]}, p, SLIDING_SIGMA_MM);
                }
            }
        }
        if (missingMm > 0) {
            pairs.add(rest.at(0), Arrays.copyOf(neckCourse(), 3), COURSE_SIGMA_MM);
        }
        return pairs;
    }
}
