package org.phrenic.study.speed;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.bare.BareScene;

/**
 * Measured speeds for the paper's table 1, by threads, and the cost of a step against the number of nodes.
 *
 * @param tables steps per second by number of threads
 * @param stepS time step of these scenes, s
 * @param scaling of the bare workload
 */
public record SpeedStudy(Map<Integer, SpeedTable> tables, double stepS, SizeScaling scaling) {
    /** The paper's material and time step with the default scheme, which needs no substeps at this step. */
    private static final List<String> SETTINGS = List.of("integrator=verlet", "time_step_s=0.01");

    private static final double STEP_S = 0.01;

    /** Numbers of nodes: the size of the paper's patient, then 20,909 to 1.3 million in factors of four. */
    private static final List<Integer> SIZES = List.of(6_633, 20_909, 83_630, 334_514, 1_338_050);

    /**
     * Extent of the measurement.
     *
     * @param resolutions of the table
     * @param threads numbers of threads
     * @param sizes approximate numbers of nodes
     * @param trials number of trials; their median is used
     * @param secondsATrial minimum duration of a trial, s
     */
    public record Settings(
            List<Resolution> resolutions,
            List<Integer> threads,
            List<Integer> sizes,
            int trials,
            double secondsATrial) {
        /** Complete measurement, about three minutes. */
        public static final Settings FULL =
                new Settings(List.of(Resolution.HIGH, Resolution.MEDIUM, Resolution.LOW), List.of(1, 2), SIZES, 7, 0.2);

        /** Low resolution, one thread and two sizes. Takes a few seconds; the results are not accurate. */
        public static final Settings QUICK =
                new Settings(List.of(Resolution.LOW), List.of(1), SIZES.subList(0, 2), 3, 0.02);

        public Settings {
            resolutions = List.copyOf(resolutions);
            threads = List.copyOf(threads);
            sizes = List.copyOf(sizes);
        }
    }

    /** Runs the measurement. */
    public static SpeedStudy of(Settings settings, ProgressListener progress) {
        int total = settings.threads().size()
                * (settings.resolutions().size() + settings.sizes().size());
        int done = 0;
        Map<Integer, List<SpeedTable.Row>> rows = new LinkedHashMap<>();
        settings.threads().forEach(threads -> rows.put(threads, new ArrayList<>()));
        for (Resolution resolution : settings.resolutions()) {
            Thorax thorax = SimulationRun.loadThorax(PaperScenarios.defaultModel("quiet", resolution));
            for (int threads : settings.threads()) {
                List<String> keys = new ArrayList<>(SETTINGS);
                keys.add("threads=" + threads);
                rows.get(threads)
                        .addAll(SpeedTrials.of(resolution, thorax, keys, settings.trials(), settings.secondsATrial()));
                progress.done(++done, total, resolution.vertices() + " vertices, threads: " + threads);
            }
        }
        Map<Integer, SpeedTable> tables = new LinkedHashMap<>();
        rows.forEach((threads, list) -> tables.put(threads, new SpeedTable(list)));
        List<SizeScaling.Row> scaling = new ArrayList<>();
        SheetWorkloads scenes = new SheetWorkloads();
        for (int size : settings.sizes()) {
            BareScene scene = scenes.ofSize(size);
            for (int threads : settings.threads()) {
                scaling.add(SizeScaling.measure(scene, threads, settings.trials(), settings.secondsATrial()));
                progress.done(++done, total, "sheet of " + scene.mesh().vertexCount() + " nodes, threads: " + threads);
            }
        }
        return new SpeedStudy(tables, STEP_S, new SizeScaling(scaling));
    }

    /** Measured speed over the paper's speed. */
    public double speedupOverPaper(int threads, Resolution resolution, SpeedCase forces) {
        return tables.get(threads).row(resolution, forces).stepsPerS() / forces.publishedStepsPerS(resolution);
    }

    /** Increase of the time per step by rib motion, other settings being equal, per cent. */
    public double ribMotionOverheadPercent(int threads, Resolution resolution) {
        return tables.get(threads).overheadPercent(resolution, SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
    }
}
