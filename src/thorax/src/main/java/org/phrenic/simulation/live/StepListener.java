package org.phrenic.simulation.live;

import java.util.function.BiConsumer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * Receives the state of a run at selected steps, one at a time, on the simulation's thread and between two steps. The
 * steps do not depend on the speed of the machine. The simulation waits for the call, so it should be short, unless it
 * may come later. Changes that it makes ({@link LiveRun#change}) apply before the next step.
 */
@FunctionalInterface
public interface StepListener {
    /** Selects steps. Evaluated after every step, so it should be cheap. */
    @FunctionalInterface
    interface Trigger {
        /**
         * Whether the listener is called at this step.
         *
         * @param step steps since the start
         * @param timeS simulated time, s
         * @param dtS time step, s
         */
        boolean isDue(long step, double timeS, double dtS);

        /** Trigger at multiples of an interval of simulated time, s, rounded to whole steps. */
        static Trigger every(double everyS) {
            return (step, timeS, dtS) -> step % Math.max(1, Math.round(everyS / dtS)) == 0;
        }
    }

    /**
     * Called at a selected step.
     *
     * @param frame current state; valid until the method returns
     * @param label respiratory phase
     */
    void onStep(Frame frame, RespiratoryPhase label);

    /**
     * Whether the next call needs the state of the body. Capturing it takes as long as ten steps; without it
     * {@link #onStepWithoutFrame} is called, except where a frame is captured for display anyway.
     */
    default boolean needsFrame() {
        return true;
    }

    /**
     * Whether {@link #onStep} may be called on another thread, while the run goes on to the next selected step that
     * does not {@linkplain #passes pass}. It then must not change the run, nor wait for it; {@link #onStepWithoutFrame}
     * is called at the step itself, before it, and may change the run.
     */
    default boolean maySeeFrameLater() {
        return false;
    }

    /**
     * Called at a selected step instead of {@link #onStep} while {@link #needsFrame} is false, and before it while
     * {@link #maySeeFrameLater} is true.
     *
     * @param timeS simulated time, s
     * @param label respiratory phase
     * @param breath number of the breath, from 1
     */
    default void onStepWithoutFrame(double timeS, RespiratoryPhase label, int breath) {}

    /**
     * Called at a selected step, instead of the other methods, while {@link #onStep} of an earlier one may be at work
     * on another thread. If it returns false it has done nothing; the run then waits for that call and makes the one of
     * this step.
     *
     * @return whether the step needs no state of the body and has been taken note of
     */
    default boolean passes(double timeS, RespiratoryPhase label, int breath) {
        return false;
    }

    /**
     * Called when the run is paused, and after each single step of a paused run, on the simulation's thread, while no
     * other call is at work and before anyone is shown the state.
     *
     * @param present current state, whether its step is selected or not; valid until the method returns
     * @param label respiratory phase
     */
    default void onPause(Frame present, RespiratoryPhase label) {}

    /**
     * This listener, whose wishes hold, and after each {@link #onStep} of it, another.
     *
     * @param other is given the same state and phase, on the same thread
     */
    default StepListener andThen(BiConsumer<Frame, RespiratoryPhase> other) {
        return new FollowedStepListener(this, other);
    }
}
