package org.phrenic.study.stability;

/**
 * What must hold in a hard case. The trusted run is velocity Verlet at an eighth of its stability limit, over the first
 * {@link StabilityCase#referenceS()}.
 *
 * @param kineticFactor kinetic energy at any sample over the largest of the trusted run
 * @param speedMmS speed of any node at any sample, mm/s
 * @param reachMm distance of any node from where it began, mm
 * @param shape rms distance of all nodes from the trusted run at the same time, while it lasts, over that run's largest
 *     rms distance from its start; infinite where trajectories may part
 * @param shapeS until when that is asked, s: where a sheet crumples or snaps through, trusted runs of different
 *     fineness part too
 * @param linkError largest | |AB| - L | / L of a rigid link
 * @param returnMm rms distance of all nodes from the start at the end of the case; infinite where it does not come back
 * @param repeatMm distance of any node at the end of any later period from where it was at the end of the first period
 *     after a minute; infinite where a motion need not repeat itself
 * @param driftMm distance of any node from where it began, once the breath is stopped at the end and the body has come
 *     to rest; infinite where it is not asked for
 */
record StabilityBounds(
        double kineticFactor,
        double speedMmS,
        double reachMm,
        double shape,
        double shapeS,
        double linkError,
        double returnMm,
        double repeatMm,
        double driftMm) {
    private static final double ANY = Double.POSITIVE_INFINITY;

    /**
     * A cough moves tissue at some 1,000 mm/s and nothing in a trunk is 300 mm from where it was; links to a
     * thousandth.
     */
    static StabilityBounds body() {
        return new StabilityBounds(ANY, 1000, 300, ANY, ANY, 1e-3, ANY, ANY, ANY);
    }

    StabilityBounds kinetic(double factor) {
        return new StabilityBounds(factor, speedMmS, reachMm, shape, shapeS, linkError, returnMm, repeatMm, driftMm);
    }

    StabilityBounds speed(double mmS) {
        return new StabilityBounds(kineticFactor, mmS, reachMm, shape, shapeS, linkError, returnMm, repeatMm, driftMm);
    }

    StabilityBounds reach(double mm) {
        return new StabilityBounds(kineticFactor, speedMmS, mm, shape, shapeS, linkError, returnMm, repeatMm, driftMm);
    }

    StabilityBounds shape(double share) {
        return new StabilityBounds(
                kineticFactor, speedMmS, reachMm, share, shapeS, linkError, returnMm, repeatMm, driftMm);
    }

    StabilityBounds shapeUntil(double seconds) {
        return new StabilityBounds(
                kineticFactor, speedMmS, reachMm, shape, seconds, linkError, returnMm, repeatMm, driftMm);
    }

    StabilityBounds links(double relative) {
        return new StabilityBounds(
                kineticFactor, speedMmS, reachMm, shape, shapeS, relative, returnMm, repeatMm, driftMm);
    }

    StabilityBounds returns(double mm) {
        return new StabilityBounds(kineticFactor, speedMmS, reachMm, shape, shapeS, linkError, mm, repeatMm, driftMm);
    }

    StabilityBounds repeats(double mm) {
        return new StabilityBounds(kineticFactor, speedMmS, reachMm, shape, shapeS, linkError, returnMm, mm, driftMm);
    }

    StabilityBounds drift(double mm) {
        return new StabilityBounds(kineticFactor, speedMmS, reachMm, shape, shapeS, linkError, returnMm, repeatMm, mm);
    }

    /** Whether a trusted run is needed. */
    boolean needsReference() {
        return kineticFactor < ANY || shape < ANY;
    }
}
