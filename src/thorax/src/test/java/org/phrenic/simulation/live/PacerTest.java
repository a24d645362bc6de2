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

    /** A simulator that computes at a share of the pace of the clock, and reports every 10 ms. */
    private void computeAt(double share, double s) {
        for (int n = 0; n < Math.round(100 * s); n++) {
            nowNs += 10_000_000;
            simulatedS += 0.01 * share;
            pacer.measure(Math.round(simulatedS / STEP_S), simulatedS);
        }
    }

    @Test
    void whoComputesAtHalfThePaceIsBehindAndWhoKeepsPaceIsNot() {
        computeAt(1, 2);
        assertThat(pacer.isBehind()).isFalse();
        assertThat(pacer.realtimeFactor()).isCloseTo(1, within(1e-9));
        computeAt(0.5, 2);
        assertThat(pacer.isBehind()).isTrue();
        assertThat(pacer.realtimeFactor()).isCloseTo(0.5, within(1e-9));
        assertThat(pacer.stepsPerS()).isCloseTo(0.5 / STEP_S, within(1 / STEP_S * 0.01));
        computeAt(1, 8);
        assertThat(pacer.isBehind()).isFalse();
    }

    /** A backlog is made up for faster than asked: nobody reads then that the run is slow. */
    @Test
    void whoCatchesUpIsBehindThePaceButNotSlow() {
        computeAt(0.5, 3);
        assertThat(pacer.isSlow()).isTrue();
        computeAt(1.15, 0.25);
        assertThat(pacer.isBehind()).isTrue();
        assertThat(pacer.isSlow()).isFalse();
    }

    @Test
    void onlyAPaceKeptBelowTheRequestedOneIsBehind() {
        pacer.setSpeed(0.5, 0);
        pacer.start(0, 0);
        computeAt(0.5, 3);
        assertThat(pacer.isBehind()).isFalse();
        // One quarter of a second is slow by a tenth.
        computeAt(0.45, 0.25);
        assertThat(pacer.realtimeFactor()).isCloseTo(0.45, within(1e-9));
        assertThat(pacer.isBehind()).isFalse();
        computeAt(0.45, 3);
        assertThat(pacer.isBehind()).isTrue();
    }

    @Test
    void theRateIsUpdatedEveryQuarterOfASecond() {
        nowNs += 249_000_000;
        assertThat(pacer.measure(100, 0.1)).isFalse();
        assertThat(pacer.realtimeFactor()).isZero();
        nowNs += 1_000_000;
        assertThat(pacer.measure(100, 0.1)).isTrue();
        assertThat(pacer.realtimeFactor()).isCloseTo(0.4, within(1e-12));
        assertThat(pacer.stepsPerS()).isCloseTo(400, within(1e-9));
    }

    @Test
    void withoutALimitItIsAlwaysBehind() {
        pacer.setSpeed(Double.POSITIVE_INFINITY, 0);
        pacer.start(0, 0);
        computeAt(20, 1);
        assertThat(pacer.isBehind()).isTrue();
    }

    @Test
    void withoutALimitNoStepNoStepWaits() {
        pacer.setSpeed(Double.POSITIVE_INFINITY, 0);
        assertThat(pacer.waitNs(1000)).isZero();
    }
}
