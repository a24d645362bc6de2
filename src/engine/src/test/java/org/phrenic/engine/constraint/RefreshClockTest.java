package org.phrenic.engine.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RefreshClockTest {
    private static final double ROUNDING = 1e-12;

    @Test
    void whatIsKeptIsTakenAnewAtFirstAndOnceAnInterval() {
        RefreshClock clock = new RefreshClock(0.02);
        int taken = 0;
        for (int step = 0; step <= 60; step++) {
            // Steps of 5 ms as a run counts them: the interval is four of them, whatever the rounding of a product.
            boolean due = clock.advanceTo(step * 0.005);
            taken += due ? 1 : 0;
            assertThat(due).isEqualTo(step % 4 == 0);
            assertThat(clock.elapsed()).isCloseTo(step % 4 * 0.005, within(ROUNDING));
        }
        assertThat(taken).isEqualTo(16);
    }

    @Test
    void aTimeThatDoesNotMoveOnOrIsForgottenTakesItAnew() {
        RefreshClock clock = new RefreshClock(1);
        assertThat(clock.advanceTo(0.5)).isTrue();
        assertThat(clock.advanceTo(0.6)).isFalse();
        assertThat(clock.advanceTo(0.6)).as("a state put back").isTrue();
        assertThat(clock.advanceTo(0.55)).as("an earlier one").isTrue();
        clock.invalidate();
        assertThat(clock.advanceTo(0.7)).isTrue();
        assertThat(clock.advanceTo(0.8)).isFalse();
        clock.setInterval(0.05);
        assertThat(clock.advanceTo(0.85)).isTrue();
    }
}
