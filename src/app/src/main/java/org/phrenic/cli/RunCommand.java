package org.phrenic.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ScenarioOptions;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.RunReport;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.error.ErrorTable;
import org.phrenic.study.error.SettingChoice;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code phrenic run}: simulates a scenario without a window. */
@Command(
        name = "run",
        description = "Simulate a scenario without a window and print what was breathed.",
        footer = {
            "",
            "Examples:",
            "  phrenic run",
            "  phrenic run scenario.yaml --out result --meshes every=0.1",
            "  phrenic run --max-error 0.02",
            "  phrenic run --preset deep --resolution low --set depth=0.8 --json",
            "",
            "DIR gets summary.json, observables.csv, scenario.yaml and, with --meshes, scene.pvd for ParaView.",
            "Keys of --set are those of a scenario file: docs/usage/run.md and docs/parameters.md.",
            "",
            Disclaimer.TEXT
        })
final class RunCommand extends ReportingCommand {
    /** Scenario keys that --max-error chooses. */
    private static final Set<String> CHOSEN = Set.of("integrator", "time_step_s", "projection_sweeps", "refresh_s");

    private static final double MIN_ERROR_MM = 1e-9;
    private static final double MAX_ERROR_MM = 1000;

    @Mixin
    private ScenarioOptions options;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder to write into; without it, nothing is written.")
    private Path out;

    @Option(names = "--meshes", paramLabel = "every=S", description = "Write the moving surfaces every S seconds.")
    private String meshes;

    @Option(
            names = "--max-error",
            paramLabel = "MM",
            description = "Take the cheapest integrator, step, sweeps and refresh that were measured to keep this rms "
                    + "error of the diaphragm.")
    private String maxError;

    @Override
    public Integer call() {
        Scenario scenario = options.resolved(meshes());
        options.requireNotIn(out, scenario);
        Map<String, String> remarks = new LinkedHashMap<>();
        if (maxError != null) {
            requireRead(
                    name -> !name.equals("--integrator") && !name.equals("--time-step"),
                    "with --max-error, which chooses it");
            options.requireSet(scenario, CHOSEN, "--max-error");
            double most = OptionValues.number("--max-error", maxError, MIN_ERROR_MM, MAX_ERROR_MM);
            SettingChoice chosen = ErrorTable.shipped().cheapest(scenario, most);
            scenario = scenario.with(chosen.settings().assignments("--max-error " + maxError));
            remarks.put("chosen", chosen.sentence(Scenario.defaults()));
        }
        Breathing.traceDescription(scenario).ifPresent(sentence -> remarks.put("trace_read", sentence));
        RunReport.run(scenario, remarks, out, err(), summary -> print(summary, () -> RunReport.table(summary)));
        return ExitCode.SUCCESS;
    }

    private Assignment[] meshes() {
        if (meshes == null) {
            return new Assignment[0];
        }
        if (out == null) {
            throw new BadInputException("--meshes " + meshes + ": found no --out, expected a folder to write into");
        }
        if (!meshes.startsWith("every=")) {
            throw new BadInputException("--meshes: found '" + meshes + "', expected every=S such as every=0.1");
        }
        String seconds = meshes.substring("every=".length());
        return new Assignment[] {Assignment.read("--meshes " + meshes, "meshes_every_s", seconds)};
    }
}
