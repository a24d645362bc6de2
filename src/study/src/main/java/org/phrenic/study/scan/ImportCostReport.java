package org.phrenic.study.scan;

import static org.phrenic.file.Numbers.format;

import java.util.List;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;

/**
 * What imports cost, as values for JSON and as a page.
 *
 * @param scan name of the scan
 * @param heap largest heap of the program, as of {@code java -Xmx}
 */
public record ImportCostReport(String scan, String heap, List<ImportCost> costs) {
    public ImportCostReport {
        costs = List.copyOf(costs);
    }

    /** One line for each size. */
    public List<List<String>> table() {
        return costs.stream()
                .map(c -> List.of(
                        c.size().toString(),
                        Integer.toString(c.labels()),
                        Integer.toString(c.structures()),
                        format("%.1f", c.firstLineS()),
                        format("%.0f", c.clockS()),
                        known("%.0f", c.processorS()),
                        known("%.2f", c.memoryMb() / 1024)))
                .toList();
    }

    private static String known(String pattern, double value) {
        return Double.isNaN(value) ? "not known" : format(pattern, value);
    }

    /** @param provenance how it was made: commit, command, machine, date */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument(
                "Cost of an import", "Time and memory of importing a scan, by its number of voxels.");
        report.points(provenance.toArray(String[]::new));
        report.paragraph(format(
                "%s, resampled to each number of voxels in the same box (nearest voxel), is imported by a process of"
                        + " its own with a heap of at most %s, from its start to its end: labels guessed, mended,"
                        + " meshed, completed, brought to end-expiration, diaphragm built, all written. Memory:"
                        + " the most that the process holds, Java's own included. Other programs at work make the"
                        + " time by the clock longer.",
                scan, heap));
        report.table(
                "",
                Column.list("voxels | # labels | # structures | # first line s | # by the clock s | # processor s"
                        + " | # memory GB"),
                table());
        return report;
    }

    /** The values for JSON. */
    public OrderedValues values() {
        return new OrderedValues()
                .with("scan", scan)
                .with("heap", heap)
                .with("imports", costs.stream().map(ImportCostReport::values).toList())
                .with("notice", Disclaimer.TEXT);
    }

    /** Without processor time and memory where the system does not tell them. */
    private static OrderedValues values(ImportCost cost) {
        OrderedValues values = new OrderedValues()
                .with("voxels", cost.size().toString())
                .with("labels", cost.labels())
                .with("structures", cost.structures())
                .with("first_line_s", cost.firstLineS())
                .with("clock_s", cost.clockS());
        if (!Double.isNaN(cost.processorS())) {
            values.put("processor_s", cost.processorS());
        }
        if (!Double.isNaN(cost.memoryMb())) {
            values.put("memory_mb", cost.memoryMb());
        }
        return values;
    }
}
