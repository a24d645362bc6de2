package org.phrenic.engine.parallel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
@Isolated("counts the threads of the process")
class WorkersTest {

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void everyPieceIsDoneOnceInEveryRound(int threads) {
        int most = 40;
        AtomicIntegerArray done = new AtomicIntegerArray(most);
        try (Workers workers = Workers.of(threads)) {
            assertThat(workers.count()).isEqualTo(threads);
            for (int round = 0; round < 4000; round++) {
                int pieces = round % (most + 1);
                workers.run(pieces, done::getAndIncrement);
                for (int i = 0; i < most; i++) {
                    int count = done.getAndSet(i, 0);
                    if (count != (i < pieces ? 1 : 0)) {
                        assertThat(count).as("piece %s of round %s", i, round).isEqualTo(i < pieces ? 1 : 0);
                    }
                }
            }
        }
    }

    /** What a round wrote is seen by the next, whichever threads did both. */
    @ParameterizedTest
    @ValueSource(ints = {2, 4})
    void aRoundSeesWhatTheLastOneWrote(int threads) {
        long[] value = new long[64];
        try (Workers workers = Workers.of(threads)) {
            for (int round = 0; round < 4000; round++) {
                workers.run(value.length, i -> value[i] += 1);
                workers.run(value.length, i -> value[63 - i] += 1);
            }
        }
        assertThat(value).containsOnly(8000);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void whatAPieceThrowsComesOutAndTheNextRoundIsWhole(int threads) {
        try (Workers workers = Workers.of(threads)) {
            for (int round = 0; round < 200; round++) {
                int bad = round % 16;
                assertThatThrownBy(() -> workers.run(16, i -> {
                            if (i == bad) {
                                throw new IllegalStateException("piece " + i);
                            }
                        }))
                        .isInstanceOf(IllegalStateException.class)
                        .hasMessage("piece " + bad);
                assertThatThrownBy(() -> workers.run(16, i -> {
                            if (i == bad) {
                                throw new StackOverflowError("piece " + i);
                            }
                        }))
                        .isInstanceOf(StackOverflowError.class)
                        .hasMessage("piece " + bad);
                AtomicIntegerArray done = new AtomicIntegerArray(16);
                workers.run(16, done::getAndIncrement);
                for (int i = 0; i < 16; i++) {
                    assertThat(done.get(i)).isEqualTo(1);
                }
            }
        }
    }

    /** A piece that fails takes no other with it, on whichever threads they are. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void theOtherPiecesAreDoneWhereOneFails(int threads) {
        for (boolean alone : new boolean[] {false, true}) {
            AtomicIntegerArray done = new AtomicIntegerArray(8);
            try (Workers workers = Workers.of(threads)) {
                workers.useCallerOnly(alone);
                assertThatThrownBy(() -> workers.run(8, i -> {
                            if (i == 2) {
                                throw new IllegalStateException("piece " + i);
                            }
                            done.getAndIncrement(i);
                        }))
                        .hasMessage("piece 2");
            }
            assertThat(done).hasToString("[1, 1, 0, 1, 1, 1, 1, 1]");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void refusesMorePiecesThanItCanCount(int threads) {
        try (Workers workers = Workers.of(threads)) {
            assertThatThrownBy(() -> workers.run(40_000_000, i -> {}))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("pieces: found 40000000, expected at most " + Workers.MOST_PIECES);
            AtomicLong sum = new AtomicLong();
            workers.run(Workers.MOST_PIECES, i -> {
                if (i == Workers.MOST_PIECES - 1) {
                    sum.addAndGet(i);
                }
            });
            assertThat(sum).hasValue(Workers.MOST_PIECES - 1);
        }
    }

    @Test
    void closeEndsTheThreads() throws InterruptedException {
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        Workers workers = Workers.of(4);
        Set<Thread> started = new HashSet<>(Thread.getAllStackTraces().keySet());
        started.removeAll(before);
        started.removeIf(thread -> !thread.getName().startsWith("phrenic-worker-"));
        assertThat(started).hasSize(3);
        workers.run(100, i -> {});
        // Long enough for the idle ones to have gone to sleep.
        Thread.sleep(20);
        workers.close();
        for (Thread thread : started) {
            thread.join(10_000);
            assertThat(thread.isAlive()).isFalse();
        }
    }

    /** More threads than cores, all cores taken by others: rounds still come to an end. */
    @Test
    void finishesWhenCoresAreTaken() {
        AtomicBoolean stop = new AtomicBoolean();
        // Tests see one processor of the machine (pom.xml), whatever it has.
        Thread[] busy = new Thread[Math.max(4, Runtime.getRuntime().availableProcessors())];
        for (int i = 0; i < busy.length; i++) {
            busy[i] = new Thread(() -> {
                while (!stop.get()) {
                    Thread.onSpinWait();
                }
            });
            busy[i].setDaemon(true);
            busy[i].start();
        }
        AtomicIntegerArray done = new AtomicIntegerArray(12);
        try (Workers workers = Workers.of(busy.length + 1)) {
            for (int round = 0; round < 300; round++) {
                workers.run(12, done::getAndIncrement);
            }
        } finally {
            stop.set(true);
        }
        for (int i = 0; i < 12; i++) {
            assertThat(done.get(i)).isEqualTo(300);
        }
    }

    @Test
    void refusesNoThreads() {
        assertThatThrownBy(() -> Workers.of(0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("threads: found 0, expected 1 or more");
    }
}
