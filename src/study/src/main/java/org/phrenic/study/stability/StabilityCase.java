package org.phrenic.study.stability;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * Scene chosen to provoke instability, with the bounds that must hold.
 *
 * @param key name on the command line
 * @param title description of the difficulty
 * @param durationS simulated time, s
 * @param quickS simulated time of the short version, s
 * @param periodS period of the drive, s; 0 if it is not periodic
 * @param referenceS maximum time covered by the reference solution, s
 */
record StabilityCase(
        String key,
        String title,
        StabilityBounds bounds,
        Factory factory,
        double durationS,
        double quickS,
        double periodS,
        double referenceS) {
    /** Assembles a scene for an integrator. */
    interface Factory {
        /**
         * @param refinement divisor of the case's time step: 1 for the case itself, more for a reference solution
         * @param durationS duration of the run, s
         * @throws IllegalArgumentException with one sentence, if the scene is refused
         */
        StabilityScene create(IntegratorKind integrator, int refinement, double durationS);
    }
}
