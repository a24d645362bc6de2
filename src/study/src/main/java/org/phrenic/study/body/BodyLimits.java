package org.phrenic.study.body;

/**
 * What a breathing body must keep with the default numbers.
 *
 * <p>Excursions: quiet 1.0 to 2.5 cm and deep 3.6 to 9.2 cm span the reference ranges of both sexes by ultrasound
 * (Boussuges et al. 2009, Chest 135:391), with a margin for the size of the body.
 */
public final class BodyLimits {
    /** Dome excursion of a quiet breath, mm. */
    public static final double QUIET_LEAST_MM = 8;

    public static final double QUIET_MOST_MM = 28;

    /** Dome excursion of a deep breath, mm. */
    public static final double DEEP_LEAST_MM = 35;

    public static final double DEEP_MOST_MM = 100;

    /** Distance of all nodes from rest at the end of a breath, rms mm. */
    public static final double RETURN_RMS_MM = 0.5;

    /** Depth of an organ's vertex on the wrong side of the diaphragm, mm. */
    public static final double THROUGH_MM = 3;

    /** Distance of the diaphragm at rest outside the inner envelope of the rib cage, greatest, mm. */
    public static final double OUTSIDE_CAGE_MM = 3;

    private BodyLimits() {}

    /** @param height of the body relative to an adult's */
    static boolean isExcursion(BreathDepth depth, double height, double mm) {
        double least = depth == BreathDepth.QUIET ? QUIET_LEAST_MM : DEEP_LEAST_MM;
        double most = depth == BreathDepth.QUIET ? QUIET_MOST_MM : DEEP_MOST_MM;
        return mm >= least * Math.min(1, height) && mm <= most * Math.max(1, height);
    }
}
