package org.phrenic.study.sweep.report;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;

/**
 * What the ways of running one study cost, as values for JSON and as a page.
 *
 * @param costs of each way that completed the study; the first is the one that the others are compared with
 * @param failures ways that did not complete it
 */
public record StudyCostReport(List<StudyCost> costs, List<FailedWay> failures) {
    private static final int PERCENT = 100;

    public StudyCostReport {
        costs = List.copyOf(costs);
        failures = List.copyOf(failures);
    }

    /** Whether every way completed the study. */
    public boolean isComplete() {
        return failures.isEmpty();
    }

    /** Whether every completed way gave the rows of the first. */
    public boolean isEqual() {
        return costs.stream().allMatch(cost -> cost.hasRowsOf(costs.get(0)));
    }

    private double speedUp(StudyCost cost) {
        return costs.get(0).elapsedS() / cost.elapsedS();
    }

    /** The values for JSON; processor times of other processes are absent. */
    public OrderedValues values() {
        List<OrderedValues> ways = costs.stream().map(this::values).toList();
        List<OrderedValues> failed = failures.stream()
                .map(failure -> new OrderedValues().with("way", failure.way()).with("reason", failure.reason()))
                .toList();
        return new OrderedValues()
                .with("ways", ways)
                .with("failed_ways", failed)
                .with("notice", Disclaimer.TEXT);
    }

    private OrderedValues values(StudyCost cost) {
        OrderedValues values = new OrderedValues()
                .with("way", cost.way())
                .with("runs_at_a_time", cost.width())
                .with("runs", cost.results().done())
                .with("failed", cost.results().failed())
                .with("elapsed_s", cost.elapsedS());
        if (cost.hasProcessorTime()) {
            values.with("processor_s", cost.processorS()).with("busy_percent", PERCENT * cost.busyShare());
        }
        return values.with("elapsed_over_runs", cost.overhead())
                .with("speed_up", speedUp(cost))
                .with("rows_equal", cost.hasRowsOf(costs.get(0)));
    }

    /** Columns of the table. */
    public static List<Column> columns() {
        return Column.list("way | # runs | # elapsed s | # processor s | # processor s a run | # busy %"
                + " | # elapsed / runs | # speed-up | rows equal");
    }

    /** Rows of the table. Processor times of other processes are not known. */
    public List<List<String>> rows() {
        List<List<String>> rows = new ArrayList<>();
        for (StudyCost cost : costs) {
            boolean known = cost.hasProcessorTime();
            rows.add(List.of(
                    cost.way(),
                    String.valueOf(cost.results().done()),
                    format("%.1f", cost.elapsedS()),
                    known ? format("%.1f", cost.processorS()) : "",
                    known ? format("%.2f", cost.processorS() / cost.results().done()) : "",
                    known ? format("%.0f", PERCENT * cost.busyShare()) : "",
                    format("%.3f", cost.overhead()),
                    format("%.2f", speedUp(cost)),
                    cost.hasRowsOf(costs.get(0)) ? "yes" : "no"));
        }
        return rows;
    }

    private String verdict() {
        if (costs.isEmpty()) {
            return "no way completed it.";
        }
        return isEqual() ? "all rows, hashes and series are equal." : "rows, hashes or series are NOT equal.";
    }

    /**
     * The page.
     *
     * @param title of the study
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(String title, List<String> provenance) {
        ReportDocument report =
                new ReportDocument("What a study costs", "\"" + title + "\" in several ways: " + verdict());
        report.points(provenance.toArray(String[]::new));
        report.paragraph(
                """
                Elapsed time is from the plan to the written results, without the start of Java and Spark; processor \
                time is that of this process. Busy: processor time / (elapsed time x runs at a time). Elapsed / runs: \
                elapsed time x runs at a time over the sum of the runs' own times, 1 if the study itself costs \
                nothing. Speed-up: against the first row. Each way generates its bodies itself.""");
        if (!costs.isEmpty()) {
            report.table("", columns(), rows());
        }
        failures.forEach(failure -> report.paragraph("Not completed: " + failure.way() + ". " + failure.reason()));
        return report;
    }
}
