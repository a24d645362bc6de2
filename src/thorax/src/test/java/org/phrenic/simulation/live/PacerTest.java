package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PacerTest {
    private static final double STEP_S = 0.001;

    private long nowNs;
    private double simulatedS;
    private final Pacer pacer = new Pacer(() -> nowNs);

    PacerTest() {
        pacer.start(0, 0);
    }

    /** Steps that take no time, whenever they are due, until a wall time. */
    private void runUntil(double wallS) {
        while (nowNs < wallS * 1e9) {
            long wait = pacer.waitNs(simulatedS);
            if (wait > 0) {
                nowNs += Math.min(wait, 1_000_000);
            } else {
                simulatedS += STEP_S;
            }
        }
    }

    private void stall(double s) {
        nowNs += (long) (1e9 * s);
    }

    @Test
    void simulatedTimeFollowsTheClockTimesTheRequestedRate() {
        pacer.setSpeed(0.5, 0);
        runUntil(4);
        assertThat(simulatedS).isCloseTo(2, within(2 * STEP_S));
    }

    @Test
    void aStallOfLessThanTheLargestBacklogIsMadeUpFor() {
        runUntil(1);
        stall(0.6);
        runUntil(10);
        assertThat(simulatedS).isCloseTo(10, within(2 * STEP_S));
    }

    @Test
    void theRateWhileCatchingUpIsLimited() {
        runUntil(1);
        stall(0.6);
        double before = simulatedS;
        runUntil(2.6);
        // One second at the largest rate, after a burst of at most 0.1 s.
        assertThat(simulatedS - before).isBetween(Pacer.CATCH_UP - 2 * STEP_S, Pacer.CATCH_UP * 1.1 + 2 * STEP_S);
    }

    @Test
    void aStallOfMoreThanTheLargestBacklogIsDropped() {
        runUntil(1);
        stall(Pacer.MAX_BACKLOG_S + 30);
        runUntil(40);
        assertThat(simulatedS).isCloseTo(40 - Pacer.MAX_BACKLOG_S - 30, within(2 * STEP_S));
    }

    @Test
    void withoutALimitNoStepWaits() {
        pacer.setSpeed(Double.POSITIVE_INFINITY, 0);
        assertThat(pacer.waitNs(1000)).isZero();
    }
}
