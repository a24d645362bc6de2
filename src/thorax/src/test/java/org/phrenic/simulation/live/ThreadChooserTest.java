package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** The choice between one thread and all, on machines that differ in what either gives. */
class ThreadChooserTest {
    private final ThreadChooser chooser = new ThreadChooser();

    /** Measures for a while on a machine with these rates; returns the share of time on all threads. */
    private double watch(int measurements, double one, double all) {
        DoubleUnaryOperator capped = rate -> Math.min(1, rate);
        int onAll = 0;
        for (int i = 0; i < measurements; i++) {
            double rate = capped.applyAsDouble(chooser.allThreads() ? all : one);
            onAll += chooser.allThreads() ? 1 : 0;
            chooser.measured(rate, rate < 0.97);
        }
        return onAll / (double) measurements;
    }

    @Test
    void oneThreadThatKeepsPaceIsNotLeft() {
        assertThat(watch(1000, 1.4, 2.5)).isZero();
    }

    @Test
    void allThreadsAreUsedWhereOneIsTooSlow() {
        assertThat(watch(100, 0.6, 1.1)).isGreaterThan(0.9);
        assertThat(watch(100, 0.6, 1.1)).isEqualTo(1);
    }

    @Test
    void allThreadsThatKeepPaceAreUsedWhereOneIsALittleTooSlow() {
        assertThat(watch(100, 0.965, 1.0)).isGreaterThan(0.9);
        assertThat(watch(100, 0.965, 1.0)).isEqualTo(1);
    }

    @Test
    void oneThreadThatFallsBehindTimeAndAgainIsLeft() {
        for (int i = 0; i < 20 && !chooser.allThreads(); i++) {
            boolean behind = i % 4 == 0;
            chooser.measured(behind ? 0.95 : 1, behind);
        }
        assertThat(chooser.allThreads()).isTrue();
    }

    @Test
    void aBusyMachineWhereTwoThreadsHinderEachOtherIsLeftAlone() {
        assertThat(watch(1000, 0.8, 0.2)).isLessThan(0.05);
    }

    @Test
    void allThreadsAreLeftWhenTheMachineGetsBusy() {
        watch(100, 0.6, 1.1);
        assertThat(chooser.allThreads()).isTrue();
        assertThat(watch(1000, 0.6, 0.2)).isLessThan(0.1);
        assertThat(chooser.allThreads()).isFalse();
    }
}
