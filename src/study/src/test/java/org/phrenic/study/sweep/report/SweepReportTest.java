package org.phrenic.study.sweep.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepOutcome;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.SweepStudy;

/** What a report of a study shows of its responses. */
class SweepReportTest {
    private static RunRow row(int index, double response) {
        return new RunRow(index, new SweepOutcome(new double[] {response}, "aa", new double[0][]), "", 1, "here");
    }

    /** Such as a volume in litres or a motion in metres. */
    @Test
    void smallResponsesHaveThreeDigits() {
        SweepPlan plan = SweepPlan.of(
                SweepStudy.parse(
                        "study.yaml",
                        """
                factors:
                  - {key: depth, values: [0.9, 1.1]}
                design: {kind: grid}
                responses: [{name: descent_m, observable: liver_si_mm, reduction: size, factor: 0.001}]
                """));
        SweepReport report = new SweepReport(new SweepResults(plan, List.of(row(0, 0.00456), row(1, 0.01234))), 0, 1);
        assertThat(report.sensitivity()).containsExactly(List.of("descent_m", "depth", "0.00778"));
        assertThat(MarkdownPage.format(report.summary(List.of())))
                .contains("| 0.00845 | 0.00550 | 0.00456 |", "| 0.0123 |");
        assertThat(MarkdownPage.format(report.summary(List.of())))
                .as("what the factor of a design without indices does")
                .contains("span of means", "| depth | 0.00778 |");
    }
}
