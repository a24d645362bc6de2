package org.phrenic.access.attempt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.access.Needle;
import org.phrenic.access.path.Crossing;
import org.phrenic.anatomy.StructureKind;

/** Loads on a needle: puncture of membranes, friction, and the beam that a side load bends. */
class NeedleLoadTest {
    private static final Needle NEEDLE = new Needle(18, 150);
    private static final Crossing LIVER = new Crossing("liver", "liver", StructureKind.LIVER, 40, 80);

    private static NeedleLoad at(Needle needle, double from, double to, boolean inLiver) {
        return NeedleLoad.advancing(needle, from, to, List.of(LIVER), inLiver, NeedleLoad.NONE);
    }

    @Test
    void theForceRisesWhileTheCapsuleIsPushedAndFallsWhenItIsCut() {
        double wall = at(NEEDLE, 38, 39, false).axialN();
        assertThat(wall).isCloseTo(0.8 + 0.39, within(1e-9));
        NeedleLoad half = at(NEEDLE, 41, 41.75, false);
        assertThat(half.layer()).isEqualTo("capsule");
        assertThat(half.axialN()).isCloseTo(0.8 + 0.4175 + 1.5 / 4, within(1e-9));
        assertThat(half.capsulePushMm()).isCloseTo(1.75, within(1e-9));
        NeedleLoad within = at(NEEDLE, 50, 51, true);
        assertThat(within.layer()).isEqualTo("liver");
        assertThat(within.axialN()).isCloseTo(0.94 + 0.51, within(1e-9)).isLessThan(0.8 + 0.435 + 1.5);
        assertThat(within.capsulePushMm()).isZero();
    }

    /** A path through two lobes: behind the first the tip is 5 mm from the second, whose capsule it then pushes. */
    @Test
    void behindALobeNoCapsuleIsPushedUntilTheNextIsMet() {
        Crossing second = new Crossing("liver", "liver", StructureKind.LIVER, 90, 120);
        NeedleLoad behind = NeedleLoad.advancing(NEEDLE, 84, 85, List.of(LIVER), false, NeedleLoad.NONE);
        assertThat(behind.capsulePushMm()).isZero();
        assertThat(behind.layer()).isEqualTo("wall");
        NeedleLoad at = NeedleLoad.advancing(NEEDLE, 91, 91.75, List.of(LIVER, second), false, NeedleLoad.NONE);
        assertThat(at.capsulePushMm()).isCloseTo(1.75, within(1e-9));
        assertThat(at.layer()).isEqualTo("capsule");
        assertThat(at.axialN()).isCloseTo(0.8 + 0.9175 + 1.5 / 4, within(1e-9));
    }

    /** A lobe of 2 mm gives way before it is cut; the tip that has left it meets nothing more of it. */
    @Test
    void behindAThinEdgeOfTheLiverNothingIsPushed() {
        Crossing edge = new Crossing("liver", "liver", StructureKind.LIVER, 40, 42);
        NeedleLoad left = NeedleLoad.advancing(NEEDLE, 42.5, 43, List.of(edge), false, NeedleLoad.NONE);
        assertThat(left.capsulePushMm()).isZero();
        assertThat(left.axialN()).isCloseTo(0.8 + 0.43, within(1e-9));
    }

    @Test
    void aFastNeedleMeetsTheSamePeakAsASlowOne() {
        assertThat(at(NEEDLE, 30, 60, true).axialN()).isCloseTo(0.94 + 0.6 + 1.5, within(1e-9));
        assertThat(at(NEEDLE, 0, 5, false).axialN()).isCloseTo(0.8 + 0.05 + 3, within(1e-9));
    }

    /** A needle of 14 G is 1.75 times as thick: so are its forces, and the push at which a membrane is cut. */
    @Test
    void aThickNeedleMeetsForcesInProportionToItsThickness() {
        Needle thick = new Needle(14, 150);
        double push = 1.75 * 3.5;
        NeedleLoad half = at(thick, 41, 40 + push / 2, false);
        assertThat(half.layer()).isEqualTo("capsule");
        assertThat(half.axialN()).isCloseTo(1.75 * (0.8 + 0.01 * (40 + push / 2) + 1.5 / 4), within(1e-9));
        assertThat(at(thick, 50, 51, true).axialN()).isCloseTo(1.75 * (0.94 + 0.51), within(1e-9));
    }

    /** The pleura is met where the recess begins. */
    @Test
    void thePleuraOfTheRecessIsPushedBeforeItIsCut() {
        Crossing recess = new Crossing(Crossing.RECESS, "Pleural recess", StructureKind.OTHER, 20, 25);
        NeedleLoad half = NeedleLoad.advancing(NEEDLE, 20, 20.75, List.of(recess, LIVER), false, NeedleLoad.NONE);
        assertThat(half.layer()).isEqualTo("pleura");
        assertThat(half.axialN()).isCloseTo(0.8 + 0.2075 + 1.0 / 4, within(1e-9));
        NeedleLoad cut = NeedleLoad.advancing(NEEDLE, 21.5, 22, List.of(recess, LIVER), false, NeedleLoad.NONE);
        assertThat(cut.layer()).isEqualTo("wall");
        assertThat(cut.axialN()).isCloseTo(0.8 + 0.22, within(1e-9));
    }

    @Test
    void theCapsuleIsPushedByTwoToSixMillimetresMoreByAThickerNeedle() {
        assertThat(NeedleLoad.capsulePushMm(new Needle(22, 150))).isBetween(2.0, 2.1);
        assertThat(NeedleLoad.capsulePushMm(NEEDLE)).isCloseTo(3.5, within(1e-9));
        assertThat(NeedleLoad.capsulePushMm(new Needle(14, 150))).isBetween(6.0, 6.2);
    }

    @Test
    void aSideLoadBendsAThinNeedleMoreAndALongOneMore() {
        // k = 3 E I / L^3 = 3 x 193,000 x 0.1018 / 50^3 = 0.4715 N/mm, in series with 0.5 N/mm of tissue.
        NeedleLoad load = NeedleLoad.aside(NEEDLE, 8, 50);
        assertThat(load.sideN()).isCloseTo(8 * 0.4715 * 0.5 / 0.9715, within(2e-3));
        assertThat(load.bendingMm()).isCloseTo(8 * 0.5 / 0.9715, within(2e-3));
        assertThat(NeedleLoad.aside(new Needle(22, 150), 8, 50).bendingMm()).isGreaterThan(load.bendingMm());
        assertThat(NeedleLoad.aside(NEEDLE, 8, 90).bendingMm()).isGreaterThan(load.bendingMm());
        assertThat(NeedleLoad.aside(NEEDLE, 8, 90).sideN()).isLessThan(load.sideN());
        assertThat(NeedleLoad.aside(NEEDLE, 0, 50).sideN()).isZero();
    }
}
