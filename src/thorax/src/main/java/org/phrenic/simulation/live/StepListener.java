package org.phrenic.simulation.live;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * Sees a run at steps of its choice, on the simulation's thread and between two steps: whatever the machine does, the
 * same run is seen at the same steps. What it does is waited for, so it should be short; what it changes in the run
 * ({@link LiveRun#change}) is changed before the next step.
 */
@FunctionalInterface
public interface StepListener {
    /** Which steps are to be seen. Asked after every step, so it should cost next to nothing. */
    @FunctionalInterface
    interface Trigger {
        /**
         * Whether this step is to be seen.
         *
         * @param step steps since the start
         * @param timeS simulated time, s
         * @param dtS time step, s
         */
        boolean isDue(long step, double timeS, double dtS);

        /** Whole multiples of an interval of simulated time, as many steps as are nearest to it, s. */
        static Trigger every(double everyS) {
            return (step, timeS, dtS) -> step % Math.max(1, Math.round(everyS / dtS)) == 0;
        }
    }

    /**
     * The scene as it stands.
     *
     * @param frame valid until it returns
     * @param label what the breath is doing
     */
    void onStep(Frame frame, RespiratoryPhase label);
}
