package org.phrenic.study.sweep.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.Numbers;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;
import org.phrenic.study.sweep.run.StudyMeasurement;
import org.phrenic.study.sweep.run.ThreadExecutor;

/** What the report states of a way that computes in other processes, and of one that did not complete the study. */
class StudyCostReportTest {
    private static final ProgressListener SILENT = (count, total, what) -> {};

    private static final String STUDY =
            """
            model: ishigami
            factors:
              - {key: x1, range: [-3, 3]}
              - {key: x2, range: [-3, 3]}
              - {key: x3, range: [-3, 3]}
            design: {kind: latin_hypercube, samples: 8, seed: %d}
            """;

    @TempDir
    private Path folder;

    private StudyCost cost(String way, boolean inProcess, int seed) {
        SweepPlan plan = SweepPlan.of(SweepStudy.parse("the study", STUDY.formatted(seed)));
        return StudyMeasurement.measure(way, folder.resolve(way), plan, new ThreadExecutor(1), inProcess, SILENT);
    }

    @Test
    void processorTimeOfOtherProcessesIsAbsent() {
        StudyCostReport report =
                new StudyCostReport(List.of(cost("here", true, 1), cost("elsewhere", false, 1)), List.of());
        assertThat(report.isEqual()).isTrue();
        String json = JsonWriter.format(report.values());
        assertThat(json.split("processor_s", -1)).as(json).hasSize(2);
        assertThat(report.rows().get(1).get(3)).isEmpty();
    }

    /** One run at a time for 10 s, of which 8 are computed, and two at a time in half of that. */
    @Test
    void speedUpBusyShareAndCostOfTheStudyAreThoseOfTheStatedTimes() {
        SweepResults runs = cost("here", true, 1).results();
        StudyCostReport report = new StudyCostReport(
                List.of(new StudyCost("one", 1, 10, 8, runs), new StudyCost("two", 2, 5, 8, runs)), List.of());
        String overhead = Numbers.format("%.3f", 10 / runs.wallS());
        assertThat(report.rows())
                .containsExactly(
                        List.of("one", "8", "10.0", "8.0", "1.00", "80", overhead, "1.00", "yes"),
                        List.of("two", "8", "5.0", "8.0", "1.00", "80", overhead, "2.00", "yes"));
        Map<?, ?> two = (Map<?, ?>) ((List<?>) report.values().get("ways")).get(1);
        assertThat(two.get("speed_up")).isEqualTo(2.0);
        assertThat(two.get("busy_percent")).isEqualTo(80.0);
        assertThat(two.get("processor_s")).isEqualTo(8.0);
        assertThat(two.get("elapsed_over_runs")).isEqualTo(10 / runs.wallS());
    }

    @Test
    void aWayWithOtherRowsIsNamed() {
        StudyCostReport report = new StudyCostReport(List.of(cost("one", true, 1), cost("other", true, 2)), List.of());
        assertThat(report.isEqual()).isFalse();
        assertThat(MarkdownPage.format(report.document("A study", List.of())))
                .contains("NOT equal")
                .containsPattern("\\| other \\|.*\\| no \\|");
    }

    @Test
    void aWayThatDidNotCompleteTheStudyIsReportedWithItsReason() {
        StudyCostReport report = new StudyCostReport(List.of(), List.of(new FailedWay("cluster", "It is lost.")));
        assertThat(report.isComplete()).isFalse();
        assertThat(MarkdownPage.format(report.document("A study", List.of())))
                .contains("no way completed it", "Not completed: cluster. It is lost.");
    }
}
