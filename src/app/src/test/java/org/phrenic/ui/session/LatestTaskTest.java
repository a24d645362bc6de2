package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

/** Tasks of which an earlier one ends after a later one. */
class LatestTaskTest {
    private final LatestTask tasks = new LatestTask();
    private final List<String> done = new ArrayList<>();
    private final List<String> failed = new ArrayList<>();

    private void begin(String name, CountDownLatch may, boolean fails) {
        tasks.execute(
                () -> {
                    may.await();
                    if (fails) {
                        throw new IllegalStateException(name);
                    }
                    return name;
                },
                done::add,
                failed::add);
    }

    @Test
    void neitherResultNorFailureOfAnEarlierTaskCountsThoughItComesLater() {
        CountDownLatch slow = new CountDownLatch(1);
        CountDownLatch quick = new CountDownLatch(0);
        EventThread.run(() -> {
            begin("slow", slow, false);
            begin("slow and bad", slow, true);
            begin("quick", quick, false);
        });
        EventThread.until("the result", () -> done.contains("quick"));
        slow.countDown();
        // A last one shows that those before have been delivered or dropped.
        EventThread.run(() -> begin("bad", slow, true));
        EventThread.until("the failure", () -> failed.contains("bad"));
        EventThread.run(() -> {
            assertThat(done).containsExactly("quick");
            assertThat(failed).containsExactly("bad");
        });
    }
}
