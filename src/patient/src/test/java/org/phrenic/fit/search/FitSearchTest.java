package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
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
        return new FitSearch(
                        PARAMETERS,
                        new FitJournal(folder.resolve(file), "mark", PARAMETERS),
                        new FitSearch.Settings(3, 7, most, Double.POSITIVE_INFINITY),
                        threads,
                        v -> new Evaluation(v, work.applyAsDouble(v)),
                        (count, best) -> {})
                .run(null);
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
        assertSame(search("three.csv", 3, EVALUATIONS, FitSearchTest::worth), one);
    }

    @Test
    void goesOnWhereItWasKilledAndMakesNoEvaluationAnew() throws IOException {
        FitSearch.Result whole = search("whole.csv", 1, EVALUATIONS, FitSearchTest::worth);
        for (int killedAfter : new int[] {1, 4, 33, 70}) {
            String file = "killed-" + killedAfter + ".csv";
            AtomicInteger made = new AtomicInteger();
            assertThatThrownBy(() -> search(file, 2, EVALUATIONS, v -> {
                        if (made.incrementAndGet() > killedAfter) {
                            throw new IllegalStateException("killed");
                        }
                        return worth(v);
                    }))
                    .hasMessage("killed");
            // A line that was being written when it was killed.
            Files.writeString(folder.resolve(file), "99,mark,0.12", StandardOpenOption.APPEND);
            AtomicInteger again = new AtomicInteger();
            FitSearch.Result resumed = search(file, 2, EVALUATIONS, v -> {
                again.incrementAndGet();
                return worth(v);
            });
            assertSame(resumed, whole);
            // What another thread was about to write when it was killed may be lost.
            assertThat(again.get())
                    .isBetween(
                            whole.trials().size() - killedAfter, whole.trials().size() - killedAfter + 1);
        }
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
        assertThatThrownBy(() -> new FitJournal(folder.resolve("other.csv"), "else", PARAMETERS))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("other.csv: found the evaluations of another fit, expected");
        assertThatThrownBy(() -> new FitJournal(folder.resolve("other.csv"), "mark", PARAMETERS.subList(0, 2)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("another fit");
    }
}
