package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.SheetSprings;

/** A search that is killed and gone on with, and one on several threads, are the same search. */
class FitSearchTest {
    private static final int EVALUATIONS = 120;
    private static final List<FitParameter> PARAMETERS = List.of(
            new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, 0.8, 0.6),
            new FitParameter(SheetSprings.MUSCLE_STIFFNESS, 100, 450, 300),
            new FitParameter(RibRotation.RIB_ROTATION, 0, 1.5, 1));

    @TempDir
    Path folder;

    /** A bowl about 0.5, 200 and 0.7, not smooth, so that no two points are worth the same. */
    private static double worth(double[] v) {
        return Math.abs(v[0] - 0.5) + Math.pow(v[1] / 200 - 1, 2) + Math.abs(v[2] - 0.7) + 0.01 * Math.sin(50 * v[0]);
    }

    private FitSearch.Result search(String file, int threads, int most, ToDoubleFunction<double[]> work) {
        return searchAttempts(file, threads, most, v -> new Evaluation(v, work.applyAsDouble(v)));
    }

    private FitSearch.Result searchAttempts(String file, int threads, int most, Function<double[], Evaluation> work) {
        return searchAttempts(file, threads, most, work, (count, best) -> {});
    }

    /** @param listener told of each evaluation once it is in the journal */
    private FitSearch.Result searchAttempts(
            String file, int threads, int most, Function<double[], Evaluation> work, FitSearch.Listener listener) {
        return new FitSearch(
                        PARAMETERS,
                        new FitJournal(folder.resolve(file), "mark", "build 1", PARAMETERS),
                        new FitSearch.Settings(3, 7, most, Double.POSITIVE_INFINITY),
                        threads,
                        work,
                        listener)
                .run(Double.POSITIVE_INFINITY, null);
    }

    private static void assertSame(FitSearch.Result found, FitSearch.Result expected) {
        assertThat(found.ended()).isEqualTo(expected.ended());
        assertThat(found.trials()).hasSameSizeAs(expected.trials());
        for (int i = 0; i < expected.trials().size(); i++) {
            assertThat(found.trials().get(i).point())
                    .containsExactly(expected.trials().get(i).point());
            assertThat(found.trials().get(i).value())
                    .isEqualTo(expected.trials().get(i).value());
        }
    }

    @Test
    void isTheSameOnAnyNumberOfThreads() {
        FitSearch.Result one = search("one.csv", 1, EVALUATIONS, FitSearchTest::worth);
        assertThat(one.best().value()).isLessThan(0.1);
        assertThat(one.startMm()).isEqualTo(one.trials().get(0).value());
        assertSame(search("three.csv", 3, EVALUATIONS, FitSearchTest::worth), one);
    }

    @Test
    void goesOnWhereItWasKilledAndMakesNoEvaluationAnew() throws IOException {
        FitSearch.Result whole = search("whole.csv", 1, EVALUATIONS, FitSearchTest::worth);
        for (int killedAfter : new int[] {1, 4, 33, 70}) {
            String file = "killed-" + killedAfter + ".csv";
            AtomicInteger made = new AtomicInteger();
            CountDownLatch written = new CountDownLatch(killedAfter);
            Function<double[], Evaluation> killed = v -> {
                if (made.incrementAndGet() > killedAfter) {
                    awaitZero(written);
                    throw new IllegalStateException("killed");
                }
                return new Evaluation(v, worth(v));
            };
            assertThatThrownBy(() -> searchAttempts(file, 2, EVALUATIONS, killed, (count, best) -> written.countDown()))
                    .hasMessage("killed");
            // A line that was being written when it was killed.
            Files.writeString(folder.resolve(file), "99,mark,0.12", StandardOpenOption.APPEND);
            AtomicInteger again = new AtomicInteger();
            FitSearch.Result resumed = search(file, 2, EVALUATIONS, v -> {
                again.incrementAndGet();
                return worth(v);
            });
            assertSame(resumed, whole);
            assertThat(again.get()).isEqualTo(whole.trials().size() - killedAfter);
        }
    }

    private static void awaitZero(CountDownLatch latch) {
        try {
            assertThat(latch.await(60, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException stopped) {
            throw new IllegalStateException("killed", stopped);
        }
    }

    /** Breaths with an activation above 0.3 fail, also the first one; the bowl's lowest place is among them. */
    @Test
    void failedBreathsAreRepeatedWithLessDriveAndTheSearchGoesOn() {
        double most = 0.3;
        AtomicInteger attempts = new AtomicInteger();
        Function<double[], Evaluation> fragile = v -> {
            attempts.incrementAndGet();
            return v[0] > most ? Evaluation.failed(v, "node 7 moves at " + v[0]) : new Evaluation(v, worth(v));
        };
        FitSearch.Result found = searchAttempts("fragile.csv", 2, 60, fragile);
        List<Evaluation> trials = found.trials();
        assertThat(trials).hasSize(FitSearchTest.generations(60));
        // 0.6, then 0.42, then 0.24.
        assertThat(trials.get(0).drive()).isEqualTo(0.4);
        assertThat(trials.get(0).failure()).startsWith("node 7 moves at 0.6");
        assertThat(found.startMm()).isNaN();
        double[] first = new SearchSpace(PARAMETERS).values(trials.get(0).point());
        assertThat(first[0]).isCloseTo(0.24, offset(1e-12));
        assertThat(first[1]).isCloseTo(300, offset(1e-9));
        assertThat(first[2]).isCloseTo(0.4, offset(1e-12));
        assertThat(trials.stream().filter(Evaluation::hasFailed)).hasSizeGreaterThan(5);
        double[] best = new SearchSpace(PARAMETERS).values(found.best().point());
        assertThat(best[0]).isLessThanOrEqualTo(most);
        assertThat(found.best().value()).isLessThan(worth(first));

        int made = attempts.get();
        FitSearch.Result again = searchAttempts("fragile.csv", 1, 60, fragile);
        assertThat(attempts).hasValue(made);
        assertSame(again, found);
        assertThat(again.trials().stream().map(Evaluation::failure))
                .containsExactlyElementsOf(
                        trials.stream().map(Evaluation::failure).toList());
    }

    @Test
    void aSearchWhoseBreathsAllFailEnds() {
        FitSearch.Result none = searchAttempts("none.csv", 1, 20, v -> Evaluation.failed(v, "the sheet is torn"));
        assertThat(none.best().drive()).isZero();
        assertThat(none.best().failure()).isEqualTo("the sheet is torn");
        assertThat(none.startMm()).isNaN();
    }

    /** Number of evaluations in whole generations of 7 after the start, at most a budget. */
    private static int generations(int budget) {
        return 1 + (budget - 1) / 7 * 7;
    }

    @Test
    void moreEvaluationsGoOnFromFewer() {
        search("more.csv", 1, 40, FitSearchTest::worth);
        assertSame(
                search("more.csv", 1, EVALUATIONS, FitSearchTest::worth),
                search("at-once.csv", 1, EVALUATIONS, FitSearchTest::worth));
    }

    @Test
    void refusesTheJournalOfAnotherFit() {
        search("other.csv", 1, 10, FitSearchTest::worth);
        assertThatThrownBy(() -> new FitJournal(folder.resolve("other.csv"), "else", "build 1", PARAMETERS))
                .isInstanceOf(ForeignJournalException.class)
                .hasMessageContaining("other.csv: found the evaluations of another fit, expected");
        assertThatThrownBy(
                        () -> new FitJournal(folder.resolve("other.csv"), "mark", "build 1", PARAMETERS.subList(0, 2)))
                .isInstanceOf(ForeignJournalException.class)
                .hasMessageContaining("another fit");
    }

    /** On several threads a journal is in the order of completion. */
    @Test
    void anEvaluationOfOtherValuesIsNamedWithItsFile() throws IOException {
        search("other.csv", 1, 10, FitSearchTest::worth);
        Path file = folder.resolve("other.csv");
        List<String> lines = new ArrayList<>(Files.readAllLines(file));
        String third = lines.remove(4);
        assertThat(third).startsWith("3,");
        lines.add(third.replaceFirst(",[^,]*$", ",0.25"));
        Files.writeString(file, String.join("\n", lines) + "\n");
        assertThatThrownBy(() -> search("other.csv", 1, 10, FitSearchTest::worth))
                .isInstanceOf(ForeignJournalException.class)
                .hasMessageStartingWith(file + ": found evaluation 3 at other values of the parameters");
    }
}
