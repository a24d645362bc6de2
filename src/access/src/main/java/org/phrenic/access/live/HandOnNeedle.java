package org.phrenic.access.live;

import java.util.Optional;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.path.SkinEntries;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.file.BadInputException;

/** The hand that holds the needle of a live run: where the needle goes in, its angles, and how deep it is aimed. */
final class HandOnNeedle {
    private final MovingAnatomy anatomy;
    private final ManualStepRecorder steps;
    private Optional<double[]> entryRest = Optional.empty();
    private Optional<SkinPoint> entry = Optional.empty();
    /** Angles of a needle that is not placed; empty if it points at the target. */
    private Optional<NeedleAngles> angles = Optional.empty();

    /** Whether the program has pointed a needle that is not placed since the entry was chosen. */
    private boolean aimedByProgram;

    HandOnNeedle(MovingAnatomy anatomy, ManualStepRecorder steps) {
        this.anatomy = anatomy;
        this.steps = steps;
    }

    /**
     * Chooses the entry point, given at end-expiration.
     *
     * @throws BadInputException if the needle is on the skin or in the body
     */
    void enter(NeedleInsertion needle, double[] onSkinAtRest, NeedleAngles initialAngles) {
        if (needle.shaft().isPlaced()) {
            throw new BadInputException("entry: found the needle on the skin or in the body, expected it out first");
        }
        SkinPoint point = SkinEntries.pointAtRest(anatomy, onSkinAtRest);
        entryRest = Optional.of(onSkinAtRest.clone());
        entry = Optional.of(point);
        angles = Optional.of(initialAngles);
        aimedByProgram = false;
    }

    /** @throws BadInputException if no entry point is chosen */
    void requireEntry() {
        if (entryRest.isEmpty()) {
            throw new BadInputException("needle: found no entry, expected a place on the skin chosen first");
        }
    }

    /** Puts the needle on the skin at the entry point, with its angles or pointed at the target. */
    void place(NeedleInsertion needle, double timeS) {
        double[] at = entryRest.orElseThrow();
        if (angles.isPresent()) {
            needle.placeAtRest(at, angles.get());
        } else {
            needle.placeAtRest(at, needle.targetNow());
        }
        PlanStep.Aim aim =
                angles.map(held -> PlanStep.Aim.at(held, aimedByProgram)).orElse(PlanStep.Aim.TARGET);
        steps.add(timeS, new PlanStep.Place("by hand, place", entryRest, false, aim));
    }

    /** Moves the tip of a placed needle to a depth. */
    void advance(NeedleInsertion needle, double depthMm, double speedMmPerS, double timeS) {
        needle.advance(depthMm, speedMmPerS);
        steps.add(timeS, new PlanStep.Advance("by hand, advance", Optional.of(depthMm), speedMmPerS, false));
    }

    /**
     * Turns the needle about its point on the skin.
     *
     * @throws BadInputException if a placed needle cannot have these angles
     */
    void turn(NeedleInsertion needle, NeedleAngles to, double timeS) {
        if (!needle.shaft().isPlaced()) {
            angles = Optional.of(to);
            return;
        }
        needle.turn(to);
        steps.add(timeS, new PlanStep.Redirect("by hand, redirect", PlanStep.Aim.at(to)));
    }

    /** Turns the needle from the angles that it has, degrees. */
    void turnBy(NeedleInsertion needle, double axialDeg, double cranialDeg, double timeS) {
        turn(needle, NeedleObserver.angles(needle, planned()).turned(axialDeg, cranialDeg), timeS);
    }

    /** Points the needle at the current position of the target. */
    void aim(NeedleInsertion needle, double timeS) {
        if (!needle.shaft().isPlaced()) {
            angles = Optional.empty();
            aimedByProgram = true;
            return;
        }
        needle.redirect(needle.targetNow());
        steps.add(timeS, new PlanStep.Redirect("by hand, redirect", PlanStep.Aim.TARGET));
    }

    /** Where a needle that is not placed will be placed, and how. */
    NeedleObserver.Planned planned() {
        return new NeedleObserver.Planned(entry, angles);
    }
}
