package org.phrenic.simulation.live;

import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;

/**
 * Sees a run at steps of its choice, on the simulation's thread and between two steps: whatever the machine does, the same run is seen at the same steps. What it does is waited for, so it should be short; what it changes in the run
 * ({@link LiveRun#change}) is changed before the next step.
 */
@FunctionalInterface
public interface Watch {
    /** Which steps are to be seen. Asked after every step, so it should cost next to nothing. */
    @FunctionalInterface
    interface When {
        /**
         * Whether this step is to be seen.
         *
         * @param step steps since the start
         * @param timeS simulated time, s
         * @param dtS time step, s
         */
        boolean isDue(long step, double timeS, double dtS);

        /** Whole multiples of an interval of simulated time, as many steps as are nearest to it, s. */
        static When every(double everyS) {
            return (step, timeS, dtS) -> step % Math.max(1, Math.round(everyS / dtS)) == 0;
        }
    }

    /**
     * The scene as it stands.
     *
     * @param frame valid until it returns
     * @param label what the breath is doing
     */
    void see(Frame frame, BreathLabel label);
}
