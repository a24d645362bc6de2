package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.ui.view.DrawingPace.Demand;

/** The pace of drawing on machines whose frames cost so much at full resolution. */
class DrawingPaceTest {
    private static final double FIXED_MS = 6;

    private final DrawingPace pace = new DrawingPace(0);
    private double nowS;
    private int changes;

    /** Draws for a while; a frame costs a fixed part and one in proportion to its pixels. */
    private void draw(double seconds, double fullCostMs, boolean onProcessor, DoubleFunction<Demand> demand) {
        double until = nowS + seconds;
        while (nowS < until) {
            double before = pace.resolution();
            double cost = FIXED_MS + (fullCostMs - FIXED_MS) * before * before;
            pace.drawn(cost, demand.apply(before), onProcessor, nowS);
            changes += pace.resolution() == before ? 0 : 1;
            nowS += Math.max(pace.intervalNs() * 1e-9, cost * 1e-3);
        }
    }

    private void draw(double seconds, double fullCostMs) {
        draw(seconds, fullCostMs, true, resolution -> Demand.NONE);
    }

    @ParameterizedTest
    @CsvSource({"5, 1", "20, 1", "30, 1", "40, 0.85", "50, 0.7", "70, 0.6", "90, 0.5", "300, 0.5"})
    void aFrameThatCostsTooMuchIsDrawnCoarser(double fullCostMs, double resolution) {
        draw(30, fullCostMs);
        assertThat(pace.resolution()).isEqualTo(resolution);
        changes = 0;
        draw(60, fullCostMs);
        assertThat(changes).as("changes once it has settled").isZero();
    }

    @Test
    void aSimulationThatIsBehindIsGivenWayToStepByStepAndFramesBecomeRarerLast() {
        draw(0.55, 20, true, resolution -> Demand.BEHIND);
        assertThat(pace.resolution()).isEqualTo(1);
        draw(0.2, 20, true, resolution -> Demand.BEHIND);
        assertThat(pace.resolution()).isEqualTo(0.85);
        draw(2, 20, true, resolution -> Demand.BEHIND);
        assertThat(pace.resolution()).isEqualTo(0.5);
        draw(3, 20, true, resolution -> Demand.BEHIND);
        assertThat(pace.intervalNs()).as("with coarse frames that cost little").isBetween(60_000_000L, 80_000_000L);
    }

    @Test
    void whoLooksAtFewFramesIsDrawnFewHoweverCheapTheyAre() {
        DrawingPace rare = new DrawingPace(400);
        for (boolean onProcessor : new boolean[] {false, true}) {
            rare.drawn(5, Demand.NONE, onProcessor, nowS);
            pace.drawn(5, Demand.NONE, onProcessor, nowS);
            assertThat(rare.intervalNs()).isEqualTo(400_000_000L);
            assertThat(pace.intervalNs()).isLessThan(20_000_000L);
        }
    }

    @Test
    void theResolutionComesBackWhenThereIsTime() {
        draw(10, 20, true, resolution -> Demand.BEHIND);
        draw(DrawingPace.FIRST_WAIT_S - 0.5, 20);
        assertThat(pace.resolution()).isEqualTo(0.5);
        draw(1, 20);
        assertThat(pace.resolution()).isEqualTo(0.6);
        draw(5 * DrawingPace.FIRST_WAIT_S, 20);
        assertThat(pace.resolution()).isEqualTo(1);
        assertThat(pace.intervalNs()).isEqualTo((long) (1e6 * DrawingPace.FRAME_MS));
    }

    @Test
    void aStepThatHasToBeTakenBackIsTriedEverMoreRarely() {
        DoubleFunction<Demand> behindAboveSeven = resolution -> resolution > 0.7 ? Demand.BEHIND : Demand.NONE;
        draw(60, 20, true, behindAboveSeven);
        changes = 0;
        draw(600, 20, true, behindAboveSeven);
        assertThat(changes).as("changes in ten minutes").isBetween(2, 20);
        assertThat(pace.resolution()).isLessThanOrEqualTo(0.85);
    }

    @Test
    void framesOfARunWithoutALimitAreRareAndFine() {
        draw(10, 20, true, resolution -> Demand.FLAT_OUT);
        assertThat(pace.resolution()).isEqualTo(1);
        assertThat(pace.intervalNs()).isEqualTo((long) (1e6 * DrawingPace.MAX_FRAME_MS));
    }

    @Test
    void aGraphicsCardDrawsSixtyFineFrames() {
        draw(10, 20, false, resolution -> Demand.BEHIND);
        assertThat(pace.resolution()).isEqualTo(1);
        assertThat(pace.intervalNs()).isEqualTo((long) (1e6 * DrawingPace.CARD_FRAME_MS));
    }

    @Test
    void framesLeaveTwoThirdsOfTheTimeToOthersUpToTheRateThatIsAimedAt() {
        draw(5, 8);
        assertThat(pace.intervalNs()).isEqualTo(24_000_000L);
        draw(5, 28);
        assertThat(1e9 / pace.intervalNs()).as("frames per second").isGreaterThan(20);
    }
}
