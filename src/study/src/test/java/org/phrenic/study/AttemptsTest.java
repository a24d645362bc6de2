package org.phrenic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.ShippedFileException;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.model.assembly.Breathing;

/** Cases that go on when one of them fails. */
class AttemptsTest {
    private static final ProgressListener SILENT = (count, total, what) -> {};

    private static Supplier<Integer> failing(String reason) {
        return () -> {
            throw new IllegalArgumentException(reason);
        };
    }

    @Test
    void casesAtTheSameTimeKeepTheirOrderAndTheirNames() {
        List<BatchRunner.Job<Integer>> jobs = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            int number = i;
            jobs.add(new BatchRunner.Job<>("case " + i, i % 7 == 3 ? failing("found " + i) : () -> number));
        }
        Attempts<Integer> one = Attempts.of(jobs, 1, SILENT);
        Attempts<Integer> four = Attempts.of(jobs, 4, SILENT);
        assertThat(one.results()).hasSize(17).isSorted().isEqualTo(four.results());
        assertThat(one.failures())
                .containsExactly("case 3: found 3", "case 10: found 10", "case 17: found 17")
                .isEqualTo(four.failures());
        assertThat(four.result("case 9")).contains(9);
        assertThat(four.result("case 10")).isEmpty();
    }

    @Test
    void whereAllFailTheFirstReasonIsThrown() {
        List<BatchRunner.Job<Integer>> jobs =
                List.of(new BatchRunner.Job<>("a", failing("first")), new BatchRunner.Job<>("b", failing("second")));
        assertThatThrownBy(() -> Attempts.of(jobs, 2, SILENT)).hasMessage("first");
    }

    /** A broken installation fails every case. */
    @Test
    void aMissingFileOfTheProgramEndsTheStudy() {
        List<BatchRunner.Job<String>> jobs = List.of(
                new BatchRunner.Job<>("a", () -> "done"),
                new BatchRunner.Job<>("b", () -> ShippedFile.text("labels/none.csv")));
        assertThatThrownBy(() -> Attempts.of(jobs, 1, SILENT)).isInstanceOf(ShippedFileException.class);
    }

    /** The effect of a parameter whose breath failed is not known, and the page says why. */
    @Test
    void aSensitivityNamesTheBreathsThatFailed() {
        Sensitivity known = new Sensitivity(
                "quiet", "a body", List.of("x"), new double[] {2}, List.of(), List.of("depth 0.9: diverged"));
        SensitivityReport report = new SensitivityReport(known);
        assertThat(report.isComplete()).isFalse();
        assertThat(MarkdownPage.format(report.document(List.of("Commit 1"))))
                .contains("## Not computed", "- depth 0.9: diverged.");
        assertThat(Sensitivity.effects(new double[] {2}, new double[] {Double.NaN}, new double[] {3}, 0.2))
                .containsExactly(Double.NaN);
    }

    /** A number that ends like zero is none. */
    @Test
    void aSensitivityOfTenIsShownAsTen() {
        double[] effects = {10, -20.001, 0.001, -0.004, Double.NaN};
        Sensitivity.Row row = new Sensitivity.Row(Breathing.DEPTH, 0.9, 1.1, effects);
        Sensitivity known = new Sensitivity(
                "quiet",
                "a body",
                List.of("a", "b", "c", "d", "e"),
                new double[effects.length],
                List.of(row),
                List.of());
        assertThat(new SensitivityReport(known).cells().get(1))
                .containsExactly("depth", "+10.00", "-20.00", "0.00", "0.00", "-");
    }
}
