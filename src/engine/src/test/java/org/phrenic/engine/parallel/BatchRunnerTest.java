package org.phrenic.engine.parallel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
class BatchRunnerTest {
    private static final ProgressListener SILENT = (count, total, what) -> {};

    private static <T> T fail(String what) {
        throw new IllegalStateException(what);
    }

    private static void waitUntilIdle(AtomicReference<Thread> thread) {
        while (thread.get() == null || thread.get().getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
    }

    /** A long job is still at work when the one beside it fails: what follows is not computed for nothing. */
    @Test
    void afterAFailureNoLaterJobStarts() {
        AtomicReference<Thread> beside = new AtomicReference<>();
        AtomicInteger ran = new AtomicInteger();
        List<BatchRunner.Job<Integer>> jobs = new ArrayList<>();
        jobs.add(new BatchRunner.Job<>("long", () -> {
            waitUntilIdle(beside);
            return 0;
        }));
        jobs.add(new BatchRunner.Job<>("bad", () -> {
            beside.set(Thread.currentThread());
            return fail("bad");
        }));
        for (int i = 0; i < 40; i++) {
            jobs.add(new BatchRunner.Job<>("later", ran::incrementAndGet));
        }
        assertThatThrownBy(() -> BatchRunner.run(jobs, 2, SILENT))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("bad");
        assertThat(ran).hasValue(0);
    }

    /** Which failure is told does not depend on which comes first in time. */
    @Test
    void theFailureOfTheFirstJobIsThrownWhereALaterOneFailsEarlier() {
        AtomicReference<Thread> beside = new AtomicReference<>();
        Supplier<Integer> slow = () -> {
            waitUntilIdle(beside);
            return fail("slow");
        };
        Supplier<Integer> quick = () -> {
            beside.set(Thread.currentThread());
            return fail("quick");
        };
        List<BatchRunner.Job<Integer>> jobs =
                List.of(new BatchRunner.Job<>("slow", slow), new BatchRunner.Job<>("quick", quick));
        assertThatThrownBy(() -> BatchRunner.run(jobs, 2, SILENT)).hasMessage("slow");
    }
}
