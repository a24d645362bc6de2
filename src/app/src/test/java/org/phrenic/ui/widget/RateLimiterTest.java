package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;

class RateLimiterTest {
    private static final long NS_PER_MS = 1_000_000;

    private final AtomicLong clock = new AtomicLong();
    private final AtomicInteger sent = new AtomicInteger();

    @Test
    void aSecondOfDraggingSendsTwentyTimes() {
        EventThread.run(() -> {
            RateLimiter throttle = new RateLimiter(sent::incrementAndGet, clock::get);
            // A mouse tells of a new place 250 times a second.
            for (int i = 0; i < 250; i++) {
                throttle.request();
                clock.addAndGet(4 * NS_PER_MS);
            }
        });
        assertThat(sent.get()).isBetween(18, 21);
    }

    @Test
    void theFirstGoesAtOnceAndTheLastIsNotLost() {
        RateLimiter throttle = EventThread.get(() -> {
            RateLimiter made = new RateLimiter(sent::incrementAndGet, clock::get);
            made.request();
            made.request();
            // The second is sent by an event of this thread, after this one.
            assertThat(sent).hasValue(1);
            return made;
        });
        EventThread.until("the second was sent", () -> sent.get() == 2);
        assertThat(throttle.isPending()).isFalse();
        EventThread.run(throttle::flush);
        assertThat(sent).hasValue(2);
    }
}
