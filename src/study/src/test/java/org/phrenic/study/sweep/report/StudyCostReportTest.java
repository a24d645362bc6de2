package org.phrenic.study.sweep.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.study.sweep.SweepPlan;
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
