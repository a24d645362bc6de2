package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.phrenic.format.BadInputException;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Change;
import org.phrenic.simulation.Scenario;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code phrenic run}: simulates a scenario without a window. */
@Command(
        name = "run",
        description = "Simulate a scenario without a window and print what was breathed.",
        footer = {
            "",
            "Examples:",
            "  phrenic run",
            "  phrenic run scenario.yaml --out result --meshes every=0.1",
            "  phrenic run --preset deep --resolution low --set depth=0.8 --json",
            "",
            "DIR gets summary.json, observables.csv, scenario.yaml and, with --meshes, scene.pvd for ParaView.",
            "Keys of --set are those of a scenario file: docs/usage.md and docs/parameters.md.",
            "",
            Notice.TEXT
        })
final class RunCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENARIO",
            description = "YAML file of what to simulate; without it, a quiet breath of the virtual adult male.")
    private Path scenario;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder to write into; without it, nothing is written.")
    private Path out;

    @Option(names = "--json", description = "Print the summary as JSON instead of a table.")
    private boolean json;

    @Option(
            names = "--anatomy",
            paramLabel = "BODY",
            description = "virtual/adult-male, virtual/adult-female or a folder.")
    private String anatomy;

    @Option(names = "--preset", paramLabel = "NAME", description = "Breathing: quiet, deep, sniff, ...")
    private String preset;

    @Option(names = "--material", paramLabel = "NAME", description = "physical or paper.")
    private String material;

    @Option(names = "--resolution", paramLabel = "NAME", description = "low, medium or high.")
    private String resolution;

    @Option(names = "--duration", paramLabel = "S", description = "Simulated time, s.")
    private String duration;

    @Option(names = "--time-step", paramLabel = "S", description = "Time step, s.")
    private String timeStep;

    @Option(names = "--integrator", paramLabel = "NAME", description = "verlet, rk4, backward-euler, ...")
    private String integrator;

    @Option(names = "--threads", paramLabel = "N", description = "Threads; the numbers do not depend on it.")
    private String threads;

    @Option(names = "--meshes", paramLabel = "every=S", description = "Write the moving surfaces every S seconds.")
    private String meshes;

    @Option(names = "--steps", paramLabel = "N", description = "So many steps, whatever the duration.")
    private String steps;

    @Option(
            names = "--change",
            paramLabel = "STEP:KEY=VALUE",
            description = "Change a key when so many steps are done; may be repeated, in the order of the steps.")
    private List<String> changes = new ArrayList<>();

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any key of the scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    @Override
    public Integer call() {
        Scenario base = scenario == null ? Scenario.defaults() : Scenario.read(scenario);
        Scenario resolved = base.with(assignments());
        if (!changes.isEmpty()) {
            resolved = resolved.withChanges(changes.stream().map(Change::parse).toList());
        }
        RunReport.run(
                resolved,
                out,
                json,
                spec.commandLine().getOut(),
                spec.commandLine().getErr());
        return ExitCode.DONE;
    }

    private List<Assignment> assignments() {
        List<Assignment> list = new ArrayList<>();
        add(list, "--anatomy", "anatomy", anatomy);
        add(list, "--preset", "preset", preset);
        add(list, "--material", "material", material);
        add(list, "--resolution", "resolution", resolution);
        add(list, "--duration", "duration_s", duration);
        add(list, "--time-step", "time_step_s", timeStep);
        add(list, "--integrator", "integrator", integrator);
        add(list, "--steps", "steps", steps);
        add(list, "--threads", "threads", threads);
        if (meshes != null) {
            if (out == null) {
                throw new BadInputException("--meshes " + meshes + ": found no --out, expected a folder to write into");
            }
            if (!meshes.startsWith("every=")) {
                throw new BadInputException("--meshes: found '" + meshes + "', expected every=S such as every=0.1");
            }
            list.add(new Assignment("--meshes " + meshes, "meshes_every_s", meshes.substring("every=".length())));
        }
        settings.forEach(text -> list.add(Assignment.parse(text)));
        return list;
    }

    private static void add(List<Assignment> list, String option, String key, String value) {
        if (value != null) {
            list.add(new Assignment(option + " " + value, key, value));
        }
    }
}
