package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.phrenic.cli.option.OutputFolder;
import org.phrenic.document.JsonWriter;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/** Runs a scenario and prints what it gave. */
public final class RunReport {
    /** How fast it went and with what: told after what was breathed. */
    private static final Set<String> PERFORMANCE_KEYS = Set.of(
            "steps",
            "substeps",
            "dt_s",
            "stability_limit_s",
            "until_first_step_s",
            "wall_s",
            "steps_per_s",
            "realtime_factor",
            "threads");

    private RunReport() {}

    /**
     * @param out folder to write into; null for none
     * @param json whether to print the summary as JSON
     */
    public static void run(Scenario scenario, Path out, boolean json, PrintWriter stdout, PrintWriter stderr) {
        run(scenario, Map.of(), out, json, stdout, stderr);
    }

    /** As the other; the summary says these remarks too, and they are printed as the run begins. */
    public static void run(
            Scenario scenario,
            Map<String, String> remarks,
            Path out,
            boolean json,
            PrintWriter stdout,
            PrintWriter stderr) {
        if (out != null) {
            OutputFolder.requireWritable(out);
        }
        ConsoleProgress progress = new ConsoleProgress(stderr, ConsoleProgress.isTerminal());
        remarks.values().forEach(progress::note);
        Map<String, Object> summary;
        try {
            summary = SimulationRun.run(scenario, out, progress, remarks);
        } finally {
            progress.end();
        }
        stdout.print(json ? JsonWriter.format(summary) : table(summary));
        stdout.flush();
    }

    /** Quantity, value, unit: first what was breathed, then how fast, then the notice. */
    public static String table(Map<String, Object> summary) {
        TextTable table = new TextTable(false, true, false).row("quantity", "value", "unit");
        summary.forEach((key, value) -> {
            if (value instanceof Number && !PERFORMANCE_KEYS.contains(key)) {
                row(table, key, value);
            }
        });
        table.row("", "", "");
        summary.forEach((key, value) -> {
            if (PERFORMANCE_KEYS.contains(key)) {
                row(table, key, value);
            }
        });
        Object chosen = summary.get("chosen");
        return table.text() + (chosen == null ? "" : "\n" + chosen + "\n") + "\n" + CliNotice.TEXT + "\n";
    }

    private static void row(TextTable table, String key, Object value) {
        QuantityKey quantity = QuantityKey.parse(key);
        table.row(quantity.label(), QuantityKey.format(value), quantity.unit());
    }
}
