package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.SimulationRun;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The scenario argument and the options that change it, shared by all commands that simulate. */
public final class ScenarioOptions {
    /** In place of a breathing preset: the published model. */
    private static final String PAPER = "paper";
    /** What the published model is besides its material, whatever a scenario file states. */
    private static final List<Setting<?>> SCHEME = List.of(
            Numerics.INTEGRATOR, Numerics.TIME_STEP, Numerics.PROJECTION_SWEEPS, Numerics.REFRESH, RigidTendon.TENDON);

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENARIO",
            description = "YAML file of what to simulate, or a folder with a body; without it, a quiet breath of the "
                    + "virtual adult male.")
    private Path scenario;

    @Option(
            names = "--anatomy",
            paramLabel = "BODY",
            description = "virtual/adult-male, virtual/adult-female, virtual/high-colon-male or a folder.")
    private String anatomy;

    @Option(
            names = "--preset",
            paramLabel = "NAME",
            description =
                    "Breathing: quiet, deep, sniff, ...; or paper: the published model (material published), with the "
                            + "breathing of SCENARIO, quiet without one.")
    private String preset;

    @Option(names = "--material", paramLabel = "NAME", description = "physical, paper or published.")
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

    @Option(names = "--steps", paramLabel = "N", description = "So many steps, whatever the duration.")
    private String steps;

    @Option(
            names = "--change",
            paramLabel = "STEP:KEY=VALUE",
            description = "Change a key when so many steps are done; may be repeated, in the order of the steps.")
    private List<String> changes = new ArrayList<>();

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any key of the scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    /**
     * Refuses an output folder in which a run would write over what the scenario is read from, or among the meshes of
     * its body.
     */
    public void requireNotIn(Path out, Scenario resolved) {
        if (out != null) {
            ReportFolder.requireNotRead("--out", out.resolve("scenario.yaml"), scenario);
            ReportFolder.requireNotRead(
                    "--out", out.resolve("observables.csv"), resolved.trace().orElse(null));
            Path body = resolved.isVirtual() ? null : Path.of(resolved.anatomy());
            SimulationRun.meshFolders(out).forEach(meshes -> ReportFolder.requireNotRead("--out", meshes, body));
        }
    }

    /**
     * Refuses keys that something else sets in {@code --set} and in changes during the run, whether of {@code --change}
     * or of the scenario file; see {@link OptionValues#assignments}.
     */
    public void requireSet(Scenario resolved, Set<String> reserved, String setter) {
        OptionValues.assignments(settings, reserved, setter);
        OptionValues.requireNone(
                resolved.changes().stream().map(ScheduledChange::assignment).toList(), reserved, setter);
    }

    /**
     * The scenario with all options applied; {@code --set} is applied last.
     *
     * @param more assignments from other options of the command
     */
    public Scenario resolved(Assignment... more) {
        boolean body = scenario != null && Files.isDirectory(scenario);
        Scenario base = scenario == null || body ? Scenario.defaults() : Scenario.read(scenario);
        List<Assignment> list = new ArrayList<>();
        OptionValues.assign(list, "SCENARIO", "anatomy", body ? scenario.toString() : null);
        OptionValues.assign(list, "--anatomy", "anatomy", anatomy);
        if (PAPER.equals(preset)) {
            if (material != null) {
                throw new BadInputException("--material " + material
                        + ": found it with --preset paper, which sets the material, expected one of them");
            }
            OptionValues.assign(list, "--preset", "material", Materials.PUBLISHED.label());
            for (Setting<?> setting : SCHEME) {
                base = base.without(setting);
            }
        } else {
            OptionValues.assign(list, "--preset", "preset", preset);
        }
        OptionValues.assign(list, "--material", "material", material);
        OptionValues.assign(list, "--resolution", "resolution", resolution);
        OptionValues.assign(list, "--duration", "duration_s", duration);
        OptionValues.assign(list, "--time-step", "time_step_s", timeStep);
        OptionValues.assign(list, "--integrator", "integrator", integrator);
        OptionValues.assign(list, "--steps", "steps", steps);
        OptionValues.assign(list, "--threads", "threads", threads);
        list.addAll(Arrays.asList(more));
        settings.forEach(text -> list.add(Assignment.parse(text)));
        if (body) {
            requireOneBody(list);
        }
        if (assigns(list, RunSettings.DURATION) && !assigns(list, RunSettings.STEPS)) {
            // The steps of a scenario file would replace the duration that is asked for here.
            base = base.without(RunSettings.STEPS);
        }
        List<ScheduledChange> scheduled =
                changes.stream().map(ScheduledChange::parse).toList();
        return scheduled.isEmpty() ? base.with(list) : base.with(list).withChanges(scheduled);
    }

    private static boolean assigns(List<Assignment> list, Setting<?> setting) {
        return list.stream().anyMatch(assignment -> assignment.setting() == setting);
    }

    /** Refuses another body beside one that is given in place of a scenario, which is the first. */
    private void requireOneBody(List<Assignment> list) {
        list.stream()
                .filter(assignment -> assignment.setting() == RunSettings.ANATOMY)
                .skip(1)
                .findFirst()
                .ifPresent(other -> {
                    throw new BadInputException(other.origin() + ": found another body than " + scenario
                            + ", which is given in place of a scenario, expected one of them");
                });
    }
}
