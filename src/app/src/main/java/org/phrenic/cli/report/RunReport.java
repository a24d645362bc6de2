package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.RunSummary;
import org.phrenic.simulation.SimulationRun;

/** Runs a scenario and formats its summary. */
public final class RunReport {
    /** Keys of performance figures, listed after the breathing quantities. */
    private static final Set<String> PERFORMANCE_KEYS = Set.of(
            "steps",
            "substeps",
            "sternum_substeps",
            "dt_s",
            "stability_limit_s",
            "until_first_step_s",
            "wall_s",
            "steps_per_s",
            "realtime_factor",
            "threads");

    private RunReport() {}

    /**
     * Runs a scenario.
     *
     * @param remarks entries added to the summary and printed when the run begins
     * @param out output folder; null for none
     * @param show gets the summary before it is written, so that a full disk loses no result
     */
    public static void run(
            Scenario scenario,
            Map<String, String> remarks,
            Path out,
            PrintWriter stderr,
            Consumer<Map<String, Object>> show) {
        if (out != null) {
            ReportFolder.requireWritable(out);
        }
        ConsoleProgress progress = new ConsoleProgress(stderr) {
            @Override
            public void measured(Map<String, Object> summary) {
                end();
                show.accept(summary);
            }
        };
        remarks.values().forEach(progress::note);
        try {
            SimulationRun.run(scenario, out, progress, remarks);
        } finally {
            progress.end();
        }
    }

    /**
     * Table of quantity, value, unit and, of a change over a breath, its peak-to-peak value: breathing quantities, then
     * performance, then the hash of the state at the end and the disclaimer.
     */
    public static String table(Map<String, Object> summary) {
        TextTable table = new TextTable(Column.list("quantity | # value | unit | # peak to peak"));
        Map<String, Object> breath = new LinkedHashMap<>(summary);
        breath.keySet().removeAll(PERFORMANCE_KEYS);
        breath.values().removeIf(value -> !(value instanceof Number));
        Set<String> peaks =
                breath.keySet().stream().map(RunSummary::peakToPeakKey).collect(Collectors.toSet());
        breath.forEach((key, value) -> {
            if (!peaks.contains(key)) {
                Object peak = summary.get(RunSummary.peakToPeakKey(key));
                addRow(table, key, value, peak == null ? "" : QuantityKey.format(peak));
            }
        });
        table.row("", "", "", "");
        Map<String, Object> performance = new LinkedHashMap<>(summary);
        performance.keySet().retainAll(PERFORMANCE_KEYS);
        performance.forEach((key, value) -> addRow(table, key, value, ""));
        Object chosen = summary.get("chosen");
        return table.text() + (chosen == null ? "" : "\n" + chosen + "\n") + "\nstate_sha256 "
                + summary.get("state_sha256") + "\n\n" + Disclaimer.TEXT + "\n";
    }

    private static void addRow(TextTable table, String key, Object value, String peakToPeak) {
        QuantityKey quantity = QuantityKey.parse(key);
        table.row(quantity.label(), QuantityKey.format(value), quantity.unit(), peakToPeak);
    }
}
