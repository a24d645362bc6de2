package org.phrenic.access.live;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.phrenic.access.plan.BreathEvent;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.live.LiveRun;

/**
 * Breath holds on command in a live run: the patient is told at an event of the breath and holds it after a reaction
 * time.
 */
final class BreathCommands {
    private final LiveRun run;
    private final ManualStepRecorder steps;
    private final double reactionS;
    private final Queue<Optional<BreathEvent.Kind>> asked = new ConcurrentLinkedQueue<>();
    /** End of a phase that was asked for last; written under the lock of what is asked. */
    private volatile Optional<BreathEvent.Kind> heldAt = Optional.empty();

    private Optional<BreathEvent> told = Optional.empty();
    private double dueS = Double.POSITIVE_INFINITY;
    private RespiratoryPhase before = RespiratoryPhase.PAUSE;
    private int breathBefore = 1;
    private double updatedS = Double.NaN;

    /** @param reactionS time from the event to the hold, s */
    BreathCommands(LiveRun run, ManualStepRecorder steps, double reactionS) {
        this.run = run;
        this.steps = steps;
        this.reactionS = reactionS;
    }

    /** Begins with the run; what was asked for and is not executed yet stays. */
    void begin() {
        synchronized (asked) {
            if (asked.isEmpty()) {
                heldAt = Optional.empty();
            }
        }
        told = Optional.empty();
        dueS = Double.POSITIVE_INFINITY;
        before = RespiratoryPhase.PAUSE;
        breathBefore = 1;
        updatedS = Double.NaN;
    }

    /**
     * Asks for a hold at the next event of a kind; a held breath is released first. Empty only releases. Executed at
     * the next {@link #update}; on any thread.
     */
    void ask(Optional<BreathEvent.Kind> at) {
        synchronized (asked) {
            asked.add(at);
            heldAt = at;
        }
    }

    private void request(Optional<BreathEvent.Kind> at, double timeS) {
        told = at.map(kind -> new BreathEvent(kind, OptionalInt.empty()));
        dueS = Double.POSITIVE_INFINITY;
        if (run.scenario().hold()) {
            hold(false, timeS);
        }
    }

    /** Holds the breath if it is time, and executes what was asked for; does nothing at the time of the last call. */
    void update(RespiratoryPhase doing, int breath, double timeS) {
        if (timeS == updatedS) {
            return;
        }
        updatedS = timeS;
        if (told.isPresent()
                && dueS == Double.POSITIVE_INFINITY
                && told.get().occurs(before, breathBefore, doing, breath)) {
            dueS = timeS + reactionS;
        }
        if (timeS >= dueS) {
            told = Optional.empty();
            dueS = Double.POSITIVE_INFINITY;
            hold(true, timeS);
        }
        before = doing;
        breathBefore = breath;
        for (Optional<BreathEvent.Kind> at = asked.peek(); at != null; at = next()) {
            request(at, timeS);
        }
    }

    /** Removes what is executed; null if nothing more is asked for. */
    private Optional<BreathEvent.Kind> next() {
        synchronized (asked) {
            asked.remove();
            return asked.peek();
        }
    }

    private void hold(boolean on, double timeS) {
        hold(on, "window");
        steps.add(timeS, new PlanStep.HoldBreath("by hand, hold_breath", on));
    }

    /** Holds or releases the breath at once, without a step of a plan. */
    void hold(boolean on, String origin) {
        run.change(List.of(Assignment.of(origin, Breathing.HOLD, on)));
    }

    /** The end of a phase at which a breath is held, or will be, as asked for last; empty if it goes on. */
    Optional<BreathEvent.Kind> heldAt() {
        return heldAt;
    }

    /** Whether the breath is held, or will be, once all that was asked for is executed; on any thread. */
    boolean isHeld() {
        synchronized (asked) {
            return heldAt.isPresent() || (asked.isEmpty() && run.scenario().hold());
        }
    }
}
