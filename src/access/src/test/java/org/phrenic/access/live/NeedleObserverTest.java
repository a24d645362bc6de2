package org.phrenic.access.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.SkinPoint;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.scenario.Scenario;

/** What is shown of a needle at an entry 90 mm from its target, with nothing at risk between them. */
class NeedleObserverTest {
    private static final double[] ENTRY = {0, 0, -20};
    private static final double[] TARGET = {90, 0, -20};
    private static final double DIAMETER_MM = 20;

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);

    private NeedleInsertion needle(double lengthMm) {
        return needle(lengthMm, TARGET);
    }

    private NeedleInsertion needle(double lengthMm, double[] at) {
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, at, DIAMETER_MM);
        return new NeedleInsertion(
                scene,
                target,
                new Needle(18, lengthMm),
                RehearsalPlan.practice(Scenario.defaults(), target, new Needle(18, lengthMm), BreathCycle.PHASES)
                        .avoided());
    }

    private NeedleState state(NeedleInsertion needle) {
        return state(needle, Optional.empty());
    }

    private NeedleState state(NeedleInsertion needle, Optional<NeedleAngles> angles) {
        RehearsalPlan plan =
                RehearsalPlan.practice(Scenario.defaults(), needle.target(), needle.needle(), BreathCycle.PHASES);
        Optional<SkinPoint> entry = Optional.of(SkinPoint.atRest(scene.skin(), ENTRY));
        return new NeedleObserver(scene, plan)
                .describe(
                        needle,
                        new HeldProbe(scene),
                        new NeedleObserver.Planned(entry, angles),
                        body.still(0),
                        RespiratoryPhase.PAUSE);
    }

    @ParameterizedTest
    @CsvSource({"91, true", "90, true", "89, false"})
    void aWayToTheTargetThatIsLongerThanTheNeedleIsNotFree(double lengthMm, boolean free) {
        NeedleState state = state(needle(lengthMm));
        assertThat(state.reasons().isEmpty()).isEqualTo(free);
        assertThat(state.marginMm() > 0).as("a margin").isEqualTo(free);
        if (!free) {
            assertThat(state.reasons()).containsExactly("is longer than the needle of 89 mm");
        }
    }

    /** Going to the target withdraws a tip that is behind it, and follows a liver that has moved since it was aimed. */
    @Test
    void theDepthOfTheTargetIsWhereItIsAndNotWhereTheTipIs() {
        NeedleInsertion needle = needle(150);
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        needle.place(ENTRY, TARGET);
        needle.advance(110, 1000);
        needle.update(body.still(1), RespiratoryPhase.PAUSE);
        NeedleState deep = state(needle);
        assertThat(deep.depthMm()).isEqualTo(110);
        assertThat(deep.aimedDepthMm()).as("the path that is judged").isEqualTo(110);
        assertThat(deep.targetDepthMm()).isCloseTo(90, within(1e-9));

        needle.advance(10, 1000);
        needle.update(body.still(2), RespiratoryPhase.PAUSE);
        needle.update(body.frame(3, 0, new double[] {7, 0, 0}, 0, 0), RespiratoryPhase.PAUSE);
        assertThat(state(needle).targetDepthMm()).isCloseTo(97, within(1e-6));
    }

    /** Places along a slanting needle are known but for rounding; that makes no needle too short for its own length. */
    @Test
    void aNeedleThatIsInUpToItsHubIsNotTooShort() {
        for (int angle = 1; angle < 20; angle++) {
            NeedleInsertion needle = needle(60);
            double[] to = {50, angle, -20 - 0.3 * angle};
            needle.place(ENTRY, to);
            assertThat(state(needle).reasons()).isEmpty();
        }
    }

    /** Insertion would push the needle through the lung, to its hub. */
    @Test
    void aNeedleThatPointsAwayFromTheTargetIsJudgedOverItsLength() {
        NeedleInsertion needle = needle(150, new double[] {90, 0, -100});
        double[] away = {0.66, 0, 0.75};
        NeedleState planned = state(needle, Optional.of(NeedleAngles.of(away)));
        assertThat(planned.aimedDepthMm()).isEqualTo(150);
        assertThat(planned.reasons()).contains("crosses lung");
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        needle.place(ENTRY, new double[] {66, 0, 55});
        for (double depthMm : new double[] {0, 2, 15}) {
            if (depthMm > 0) {
                needle.advance(depthMm, 1000);
                needle.update(body.still(depthMm), RespiratoryPhase.PAUSE);
            }
            NeedleState placed = state(needle);
            assertThat(placed.depthMm()).isEqualTo(depthMm);
            assertThat(placed.aimedDepthMm()).isEqualTo(150);
            assertThat(placed.reasons()).contains("crosses lung");
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 90", "44, 64.7", "46, 150", "80, 150", "88, 150", "91, 150"})
    void aNeedleThatPointsFarAsideOfTheTargetIsJudgedOverItsLength(double aside, double judgedMm) {
        double angle = Math.toRadians(aside);
        NeedleAngles angles = NeedleAngles.of(new double[] {Math.cos(angle), 0, Math.sin(angle)});
        NeedleInsertion needle = needle(150);
        assertThat(state(needle, Optional.of(angles)).aimedDepthMm()).isCloseTo(judgedMm, within(0.1));
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        needle.placeAtRest(ENTRY, angles);
        assertThat(state(needle).aimedDepthMm()).isCloseTo(judgedMm, within(0.1));
    }

    @Test
    void aNeedleThatIsTurnedAwayInTheWallIsJudgedOverItsLength() {
        NeedleInsertion needle = needle(150, new double[] {90, 0, -100});
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        needle.place(ENTRY, new double[] {90, 0, -100});
        needle.advance(15, 1000);
        needle.update(body.still(1), RespiratoryPhase.PAUSE);
        needle.turn(NeedleAngles.of(new double[] {0.66, 0, 0.75}));
        assertThat(state(needle).reasons()).contains("crosses lung");
    }
}
