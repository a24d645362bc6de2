package org.phrenic.study.hard;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * A scene chosen to break a simulation, and what must hold in it.
 *
 * @param key name on the command line
 * @param title what is hard about it
 * @param bounds what must hold
 * @param maker puts it together
 * @param durationS simulated time, s
 * @param quickS simulated time of the short version, s
 * @param periodS of what drives it, s; 0 where it does not repeat itself
 * @param trustedS how much of it the trusted run covers at most, s
 */
record HardCase(
        String key,
        String title,
        Bounds bounds,
        Maker maker,
        double durationS,
        double quickS,
        double periodS,
        double trustedS) {

    /** Puts a scene together for an integrator. */
    interface Maker {
        /**
         * @param kind the scheme
         * @param refinement parts into which the case's time step is cut: 1 as the case has it, more for a trusted run
         * @param durationS how long it will run, s
         * @throws IllegalArgumentException with one sentence, if the scene is refused
         */
        Trial make(IntegratorKind kind, int refinement, double durationS);
    }
}
