package org.phrenic.simulation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.file.FolderLock;
import org.phrenic.file.UserCache;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.SceneObserver;

/** Headless run of a scenario from start to end: body, simulation, observables, files. */
public final class SimulationRun {
    /** Receives the progress of a run. */
    public interface Progress {
        void advanced(double simulatedS, double totalS, double stepsPerS);

        /** A remark to show once, such as a mesh repair or the use of substeps. */
        default void note(String sentence) {}

        /** How far the scene has settled before the first step; called again and again if it takes long. */
        default void settling(double doneS, double totalS) {}

        /** The summary, before any file of it is written. */
        default void measured(Map<String, Object> summary) {}
    }

    /** Relative rounding error of a number of steps, which must not add a step. */
    private static final double ROUNDING = 1e-12;

    private static final double PROGRESS_EVERY_S = 0.1;

    private SimulationRun() {}

    /** Loads the body that a scenario names. */
    public static Thorax loadThorax(Scenario scenario) {
        if (scenario.isVirtual()) {
            String preset = scenario.anatomy().substring("virtual/".length());
            return VirtualThorax.ofPreset(preset, OrganSettings.budget(scenario), UserCache.ofUser());
        }
        return ThoraxFolder.load(Path.of(scenario.anatomy()));
    }

    /** The folders in {@code out} into which a run writes meshes, and in which it deletes those of an earlier one. */
    public static List<Path> meshFolders(Path out) {
        return RunRecorder.meshFolders(out);
    }

    /**
     * Runs a scenario.
     *
     * @param out folder for summary.json, observables.csv, scenario.yaml and meshes; null to write nothing
     * @return the summary, in output order
     */
    public static Map<String, Object> run(Scenario scenario, Path out, Progress progress) {
        return run(scenario, out, progress, Map.of());
    }

    /**
     * Runs a scenario.
     *
     * @param out folder for the output files; null to write nothing
     * @param remarks additional entries of the summary, such as why a setting was chosen
     */
    public static Map<String, Object> run(Scenario scenario, Path out, Progress progress, Map<String, String> remarks) {
        long begun = System.nanoTime();
        ScheduleCheck.require(scenario);
        ObservableRows.require(scenario, Runtime.getRuntime().maxMemory());
        Thorax thorax = loadThorax(scenario);
        thorax.notes().forEach(progress::note);
        try (Simulation simulation = Simulation.of(scenario, thorax, UserCache.ofUser(), progress)) {
            UserCache.ofUser().takeNotes().forEach(progress::note);
            if (!simulation.stabilityMessage().isEmpty()) {
                progress.note(simulation.stabilityMessage());
            }
            double untilFirstStep = (System.nanoTime() - begun) * 1e-9;
            try (FolderLock lock = out == null ? null : FolderLock.of(out)) {
                RunRecorder recorder = new RunRecorder(scenario, simulation, lock == null ? null : lock.folder());
                List<Observation> samples = new ArrayList<>();
                double stepping = stepToEnd(scenario, simulation, samples, recorder, progress);
                Map<String, Object> summary = summary(scenario, simulation, thorax, samples, stepping, untilFirstStep);
                summary.putAll(remarks);
                progress.measured(summary);
                recorder.writeResults(summary, samples);
                return summary;
            }
        }
    }

    /** Steps that a time takes, the last of which may reach beyond it: a run ends no earlier than its last breath. */
    public static long stepsFor(double seconds, double dt) {
        long steps = Math.max(0, (long) Math.ceil(seconds / dt * (1 - ROUNDING)));
        return steps * dt < seconds ? steps + 1 : steps;
    }

    /**
     * Steps to the end, observes the scene at a fixed interval of steps and records meshes at theirs; returns the wall
     * time of stepping, s.
     */
    private static double stepToEnd(
            Scenario scenario,
            Simulation simulation,
            List<Observation> samples,
            RunRecorder recorder,
            Progress progress) {
        double total = scenario.durationS(simulation.scene().drive().pattern());
        double dt = simulation.stepper().dt();
        long end = scenario.steps() >= 0 ? scenario.steps() : Math.max(1, stepsFor(total, dt));
        SceneObserver observer = new SceneObserver(simulation.scene());
        samples.add(observer.observe(0));
        recorder.recordMeshes(0);
        long stepping = 0;
        long told = System.nanoTime();
        String finer = "";
        double recordS = scenario.get(RunSettings.RECORD_EVERY);
        long nextSample = sampleInterval(recordS, dt);
        while (simulation.steps() < end) {
            long chunk = Math.min(
                    Math.min(nextSample, end) - simulation.steps(), recorder.stepsToMeshes(simulation.time(), dt));
            long start = System.nanoTime();
            for (long i = 0; i < chunk && simulation.stepper().dt() == dt; i++) {
                simulation.step();
            }
            long now = System.nanoTime();
            stepping += now - start;
            if (!simulation.stepper().substepRefinementReason().equals(finer)) {
                finer = simulation.stepper().substepRefinementReason();
                progress.note(simulation.stabilityMessage());
            }
            if (simulation.stepper().dt() != dt) {
                // The time step changed during the run; the remaining time takes another number of steps.
                dt = simulation.stepper().dt();
                end = scenario.steps() >= 0 ? end : simulation.steps() + stepsFor(total - simulation.time(), dt);
                double sampledS = samples.get(samples.size() - 1).get("time_s");
                nextSample = simulation.steps() + stepsFor(sampledS + recordS - simulation.time(), dt);
            }
            if (simulation.steps() >= Math.min(nextSample, end)) {
                samples.add(observer.observe(simulation.time()));
                nextSample = simulation.steps() + sampleInterval(recordS, dt);
            }
            recorder.recordMeshes(simulation.time());
            if ((now - told) * 1e-9 > PROGRESS_EVERY_S || simulation.steps() >= end) {
                told = now;
                double endS = simulation.time() + (end - simulation.steps()) * dt;
                progress.advanced(simulation.time(), endS, simulation.steps() / (stepping * 1e-9));
            }
        }
        return stepping * 1e-9;
    }

    static long sampleInterval(double recordS, double dt) {
        return Math.max(1, Math.round(recordS / dt));
    }

    private static Map<String, Object> summary(
            Scenario scenario,
            Simulation simulation,
            Thorax thorax,
            List<Observation> samples,
            double stepping,
            double untilFirstStep) {
        Scene scene = simulation.scene();
        Stepper stepper = simulation.stepper();
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("scenario", scenario.name());
        map.put("anatomy", thorax.name());
        map.put("material", scenario.material().label());
        map.put("resolution", scenario.resolution().name().toLowerCase(java.util.Locale.ROOT));
        if (scenario.get(OrganSettings.MESH_VERTICES) > 0) {
            map.put("mesh_vertices", scenario.get(OrganSettings.MESH_VERTICES));
        }
        map.put("integrator", stepper.integrator().kind().label());
        map.put("nodes", scene.system().nodeCount());
        map.put("springs", scene.springCount());
        map.put("rigid_links", scene.activeLinks().map(l -> l.count()).orElse(0));
        map.put("attachments", scene.heldNodes().length);
        map.put("steps", stepper.steps());
        if (simulation.settings().get(Breathing.REPEAT)) {
            map.put("repeated_steps", simulation.repeatedSteps());
        }
        map.put("substeps", stepper.substeps());
        if (stepper.system().layout().hasNodesApart()) {
            map.put("sternum_substeps", stepper.substeps() * stepper.stepsApart());
        }
        map.put("dt_s", stepper.dt());
        double limit = stepper.limit().largestStep(stepper.integrator().kind());
        if (Double.isFinite(limit)) {
            map.put("stability_limit_s", limit);
        }
        map.put("until_first_step_s", untilFirstStep);
        map.put("wall_s", stepping);
        map.put("steps_per_s", stepping > 0 ? stepper.steps() / stepping : 0.0);
        map.put("realtime_factor", stepping > 0 ? stepper.time() / stepping : 0.0);
        map.put("prestress_residual", scene.prestressResidual());
        map.put("mass_added_percent", scene.nodeMasses().addedPercent());
        map.put("settled_by_rms_mm", simulation.settlingDisplacementMm());
        map.putAll(new RunSummary(samples, scene.drive().pattern().cutShortS()).toMap());
        map.put("threads", scenario.threads());
        map.put("state_sha256", simulation.stateHash());
        map.put("notice", org.phrenic.document.report.Disclaimer.TEXT);
        return map;
    }
}
