package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.scenario.Scenario;

/** Which path a report shows over the breath, of attempts with two punctures: straight to the target, and slanting. */
class DecisivePathTest {
    private static final double AT_ONCE = 1e6;
    private static final double[] STRAIGHT = {0, 0, -20};
    private static final double STRAIGHT_MM = 90;
    private static final double[] SLANTING = {0, 67.5, -20};
    private static final double SLANTING_MM = 112.5;

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);
    private final List<PlanStep> steps = new ArrayList<>();
    private RehearsalPlan practice;
    private NeedleInsertion needle;
    private int frames;

    @BeforeEach
    void begin() {
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        practice = RehearsalPlan.practice(Scenario.defaults(), target, Needle.standard(), 1);
        needle = new NeedleInsertion(scene, target, practice.needle(), practice.avoided());
        next();
    }

    private void next() {
        needle.update(body.still(frames++), RespiratoryPhase.PAUSE);
    }

    private void puncture(double[] entry, double depthMm) {
        needle.placeAtRest(entry, needle.targetNow());
        steps.add(new PlanStep.Place("place", Optional.of(entry), false, PlanStep.Aim.TARGET));
        needle.advance(depthMm, AT_ONCE);
        steps.add(new PlanStep.Advance("advance", Optional.of(depthMm), AT_ONCE, true));
        next();
    }

    private void sample() {
        needle.sample();
        steps.add(new PlanStep.Sample("sample"));
    }

    /** Length of the path that is shown, mm. */
    private double shownMm() {
        RehearsalPlan plan = practice.withSteps(needle.target(), steps, frames);
        List<BreathMoment> breath = List.of(new BreathMoment(body.still(0), RespiratoryPhase.PAUSE, 4));
        try (Workers workers = Workers.of(1)) {
            TargetAccess access =
                    TargetAccess.of(scene, breath, needle.target(), plan.needle(), plan.avoided(), workers);
            return Rehearsal.plannedPath(plan, access, scene, needle.record())
                    .orElseThrow()
                    .analyses()
                    .get(0)
                    .lengthMm();
        }
    }

    @Test
    void itIsThatOfThePunctureWithTheSampleAndNotOfOneBefore() {
        puncture(STRAIGHT, 30);
        puncture(SLANTING, 110);
        sample();
        assertThat(shownMm()).isCloseTo(SLANTING_MM, within(1e-3));
    }

    @Test
    void itIsThatOfTheSampleThatHitAndNotOfOneThatMissed() {
        puncture(STRAIGHT, 88);
        sample();
        puncture(SLANTING, 50);
        sample();
        assertThat(needle.record().verdict()).isEqualTo("Hit in 1 of 2 samples");
        assertThat(shownMm()).isCloseTo(STRAIGHT_MM, within(1e-3));
    }

    @Test
    void withoutASampleItIsThatOfTheLastPuncture() {
        puncture(STRAIGHT, 30);
        puncture(SLANTING, 30);
        assertThat(shownMm()).isCloseTo(SLANTING_MM, within(1e-3));
    }
}
