package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.phrenic.format.Json;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SimulationRun;

/** Runs a scenario and prints what it gave. */
final class RunReport {
    /** How fast it went and with what: told after what was breathed. */
    private static final Set<String> SPEED = Set.of(
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
    static void run(Scenario scenario, Path out, boolean json, PrintWriter stdout, PrintWriter stderr) {
        run(scenario, Map.of(), out, json, stdout, stderr);
    }

    /** As the other; the summary says these remarks too, and they are printed as the run begins. */
    static void run(
            Scenario scenario,
            Map<String, String> remarks,
            Path out,
            boolean json,
            PrintWriter stdout,
            PrintWriter stderr) {
        if (out != null) {
            OutputFolder.require(out);
        }
        ProgressPrinter progress = new ProgressPrinter(stderr, ProgressPrinter.isTerminal());
        remarks.values().forEach(progress::note);
        Map<String, Object> summary;
        try {
            summary = SimulationRun.execute(scenario, out, progress, remarks);
        } finally {
            progress.end();
        }
        stdout.print(json ? Json.format(summary) : table(summary));
        stdout.flush();
    }

    /** Quantity, value, unit: first what was breathed, then how fast, then the notice. */
    static String table(Map<String, Object> summary) {
        Table table = new Table(false, true, false).row("quantity", "value", "unit");
        summary.forEach((key, value) -> {
            if (value instanceof Number && !SPEED.contains(key)) {
                row(table, key, value);
            }
        });
        table.row("", "", "");
        summary.forEach((key, value) -> {
            if (SPEED.contains(key)) {
                row(table, key, value);
            }
        });
        Object chosen = summary.get("chosen");
        return table.text() + (chosen == null ? "" : "\n" + chosen + "\n") + "\n" + Notice.TEXT + "\n";
    }

    private static void row(Table table, String key, Object value) {
        Quantity quantity = Quantity.of(key);
        table.row(quantity.label(), Quantity.shown(value), quantity.unit());
    }
}
