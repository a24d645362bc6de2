package org.phrenic.study.stability;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * A scene chosen to break a simulation, and what must hold in it.
 *
 * @param key name on the command line
 * @param title what is hard about it
 * @param durationS simulated time, s
 * @param quickS simulated time of the short version, s
 * @param periodS of what drives it, s; 0 where it does not repeat itself
 * @param referenceS how much of it the reference solution covers at most, s
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
         * @param refinement parts into which the case's time step is cut: 1 as the case has it, more for a reference
         * @param durationS how long it will run, s
         * @throws IllegalArgumentException with one sentence, if the scene is refused
         */
        StabilityScene create(IntegratorKind integrator, int refinement, double durationS);
    }
}
