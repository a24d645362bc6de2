package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshots;
import org.phrenic.access.path.AccessMap;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/** Executes the steps of a plan. After each frame, it executes all steps whose conditions are met. */
public final class PlanPlayer {
    /** Controls breath holds. */
    public interface Breathing {
        void hold(boolean held, String origin);
    }

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private final RehearsalPlan plan;
    private final NeedleInsertion needle;
    private final NeedleSnapshots snapshots;
    private final HeldProbe probe;
    private final AccessMap map;
    private final Breathing breathing;
    private int next;
    private boolean begun;
    private double aimedMm;
    private double sinceS;
    private RespiratoryPhase before = RespiratoryPhase.PAUSE;
    private int breathBefore = 1;
    /** The event, with the number of its breath, that ended the last wait. */
    private Optional<BreathEvent> awaited = Optional.empty();

    private boolean held;
    /** Whether the breath stands still because a step holds it. A pattern with a breath hold of its own goes on. */
    private boolean still;

    /**
     * @param snapshots gets the needle after each step
     * @param map access map of the target, for steps that use its best entry points
     */
    public PlanPlayer(
            RehearsalPlan plan,
            NeedleInsertion needle,
            NeedleSnapshots snapshots,
            HeldProbe probe,
            AccessMap map,
            Breathing breathing) {
        this.snapshots = snapshots;
        this.probe = probe;
        this.plan = plan;
        this.needle = needle;
        this.map = map;
        this.breathing = breathing;
    }

    /** Moves needle and probe to a frame, and executes all steps that are possible then. */
    boolean update(Frame frame, RespiratoryPhase phase) {
        needle.update(frame, phase);
        probe.update(frame, needle);
        return update(frame, phase, 1 + (int) frame.values()[BREATH]);
    }

    /**
     * Executes all steps that are possible at this frame, to which needle and probe have been moved.
     *
     * @param breath number of the breath, starting at 1
     * @return whether all steps are done
     * @throws BadInputException if a step cannot be executed or its event does not occur; the message names the step
     */
    public boolean update(Frame frame, RespiratoryPhase phase, int breath) {
        List<PlanStep> steps = plan.steps();
        still = phase == RespiratoryPhase.HOLD && (held || still);
        snapshots.observe(needle, frame, phase);
        while (next < steps.size() && isDone(steps.get(next), phase, breath)) {
            if (steps.get(next) instanceof PlanStep.Image) {
                snapshots.image(needle, frame, phase);
            }
            snapshots.observe(needle, frame, phase);
            next++;
            begun = false;
        }
        if (!still) {
            before = phase;
            breathBefore = breath;
        }
        return next == steps.size();
    }

    private boolean isDone(PlanStep step, RespiratoryPhase phase, int breath) {
        try {
            if (needle.timeS() > plan.timeoutS()) {
                String missed = step instanceof PlanStep.WaitFor w
                        ? ", there was no " + w.event().text()
                        : "";
                throw new BadInputException(Numbers.format(
                        "found it not done after %.0f s%s, expected it sooner (give_up_after_s)",
                        plan.timeoutS(), missed));
            }
            boolean first = !begun;
            if (first) {
                begun = true;
                sinceS = needle.timeS();
            }
            return isDone(step, first, phase, breath);
        } catch (BadInputException bad) {
            throw new BadInputException(step.place() + ": " + bad.getMessage(), bad);
        }
    }

    private boolean isDone(PlanStep step, boolean first, RespiratoryPhase phase, int breath) {
        if (step instanceof PlanStep.WaitFor wait) {
            return occurs(wait.event(), phase, breath);
        }
        if (step instanceof PlanStep.WaitSeconds wait) {
            return needle.timeS() - sinceS >= wait.seconds() - 1e-9;
        }
        if (step instanceof PlanStep.HoldBreath hold) {
            held = hold.held();
            breathing.hold(held, hold.place());
        } else if (step instanceof PlanStep.Place place) {
            place(entry(place, map), place.aim());
        } else if (step instanceof PlanStep.Redirect redirect) {
            redirect(redirect.aim());
        } else if (step instanceof PlanStep.Probe held) {
            probe.hold(held.hold());
        } else if (step instanceof PlanStep.Advance advance) {
            if (first) {
                move(advance);
            }
            return !advance.awaited() || !needle.isMoving();
        } else if (step instanceof PlanStep.Sample) {
            needle.sample();
        }
        return true;
    }

    private void move(PlanStep.Advance step) {
        double toMm = step.depthMm().orElse(aimedMm);
        double depthMm = needle.shaft().depth();
        if (step.back() && needle.shaft().isPlaced() && toMm > depthMm) {
            throw new BadInputException(Numbers.format(
                    "depth_mm: found %.1f mm with the tip at %.1f mm, expected a depth that is not beyond the tip's",
                    toMm, depthMm));
        }
        needle.advance(toMm, step.speedMmPerS());
    }

    private void place(double[] entry, PlanStep.Aim aim) {
        if (aim.angles().isPresent()) {
            needle.placeAtRest(entry, aim.angles().get());
            aimedMm = needle.targetDepthMm();
        } else {
            needle.placeAtRest(entry, point(aim));
            aimedMm = Vectors.distance(needle.shaft().entry(), point(aim));
        }
    }

    private void redirect(PlanStep.Aim aim) {
        if (aim.angles().isPresent()) {
            needle.turn(aim.angles().get());
            aimedMm = needle.targetDepthMm();
        } else {
            needle.redirect(point(aim));
            aimedMm = Vectors.distance(needle.shaft().entry(), point(aim));
        }
    }

    private boolean occurs(BreathEvent event, RespiratoryPhase phase, int breath) {
        boolean hold = event.kind() == BreathEvent.Kind.HOLD;
        OptionalInt number =
                still && !hold ? OptionalInt.empty() : event.occurrence(before, breathBefore, phase, breath);
        Optional<BreathEvent> occurred =
                number.isPresent() ? Optional.of(new BreathEvent(event.kind(), number)) : Optional.empty();
        // A wait for the next event of a kind, but for a hold, is not ended by the one that ended the wait before it.
        if (number.isPresent() && (hold || event.breath().isPresent() || !occurred.equals(awaited))) {
            awaited = occurred;
            return true;
        }
        if (event.breath().isPresent() && breath > event.breath().getAsInt()) {
            throw new BadInputException(
                    Numbers.format("found %s over at %.1f s, expected a later breath", event.text(), needle.timeS()));
        }
        return false;
    }

    /**
     * The entry point of a step, on the skin at end-expiration.
     *
     * @throws BadInputException if the needle is too short or no path is free
     */
    static double[] entry(PlanStep.Place place, AccessMap map) {
        double margin = AccessMap.SUFFICIENT_MARGIN_MM;
        return place.entryRest()
                .or(() -> (place.atEndExpiration() ? map.bestAt(0, margin) : map.best(margin)).map(map::pointAtRest))
                .orElseThrow(() -> new BadInputException(place.place()
                        + (map.counts().inReach() == 0
                                ? ": found the needle too short to reach the target from anywhere on the skin,"
                                        + " expected a longer one"
                                : ": found no free path to the target from anywhere on the skin"
                                        + (place.atEndExpiration() ? " at end-expiration" : "") + ", expected one")));
    }

    private double[] point(PlanStep.Aim aim) {
        return aim.point().orElseGet(() -> aim.atRest() ? needle.target().restMm() : needle.targetNow());
    }
}
