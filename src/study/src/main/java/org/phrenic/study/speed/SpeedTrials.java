package org.phrenic.study.speed;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.study.PaperScenarios;

/**
 * Measures the paper's table 1: its material, the four cases of a resolution in turn so that whatever else the machine
 * does falls on all of them. Counted on one thread is processor time, which on a machine with nothing else to do is the
 * time on the clock; on several threads the clock.
 */
public final class SpeedTrials {
    /**
     * The paper's scheme on one thread, at a step within its stability limit so that an iteration is one step and not
     * several.
     */
    public static final List<String> SCHEME = List.of("integrator=rk2", "time_step_s=0.0005", "threads=1");

    private SpeedTrials() {}

    /**
     * Measures one resolution.
     *
     * @param settings keys of a scenario: scheme, step, threads
     * @param trials of each case
     * @param trialS what a trial takes, s
     */
    public static List<SpeedTable.Row> of(
            Resolution resolution, Thorax thorax, List<String> settings, int trials, double trialS) {
        List<Simulation> scenes = new ArrayList<>();
        try {
            for (SpeedCase forces : SpeedCase.values()) {
                scenes.add(Simulation.of(scenario(resolution, settings, forces), thorax));
            }
            int[] steps = new int[scenes.size()];
            for (int i = 0; i < steps.length; i++) {
                stepsPerS(scenes.get(i), trialS);
                steps[i] = (int) Math.max(5, trialS * stepsPerS(scenes.get(i), trialS));
            }
            List<List<Double>> rates = new ArrayList<>();
            scenes.forEach(scene -> rates.add(new ArrayList<>()));
            for (int trial = 0; trial < trials; trial++) {
                for (int i = 0; i < steps.length; i++) {
                    rates.get(i).add(stepsPerS(scenes.get(i), steps[i]));
                }
            }
            return IntStream.range(0, steps.length)
                    .mapToObj(i -> new SpeedTable.Row(
                            resolution,
                            SpeedCase.values()[i],
                            scenes.get(i).system().nodeCount(),
                            rates.get(i)))
                    .toList();
        } finally {
            scenes.forEach(Simulation::close);
        }
    }

    /**
     * Real time that the paper's material takes up on one thread with the scheme and the step that are used here
     * without being asked: simulated time over processor time.
     */
    public static double realTimeFactor(Resolution resolution, Thorax thorax, double trialS) {
        try (Simulation scene =
                Simulation.of(PaperScenarios.publishedModel("deep", resolution).with("threads=1"), thorax)) {
            stepsPerS(scene, trialS);
            return stepsPerS(scene, trialS) * scene.stepper().dt();
        }
    }

    private static Scenario scenario(Resolution resolution, List<String> settings, SpeedCase forces) {
        return PaperScenarios.publishedModel("deep", resolution)
                .with(settings.toArray(String[]::new))
                .with(forces.setting());
    }

    /** Steps a second over a stretch of about so many seconds: the warm-up. */
    private static double stepsPerS(Simulation simulation, double seconds) {
        long begun = nanos(simulation);
        int steps = 0;
        do {
            simulation.step();
            steps++;
        } while ((nanos(simulation) - begun) * 1e-9 < seconds);
        return steps / ((nanos(simulation) - begun) * 1e-9);
    }

    private static double stepsPerS(Simulation simulation, int steps) {
        long begun = nanos(simulation);
        for (int i = 0; i < steps; i++) {
            simulation.step();
        }
        return steps / ((nanos(simulation) - begun) * 1e-9);
    }

    private static long nanos(Simulation simulation) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return simulation.system().workers().count() == 1 && threads.isCurrentThreadCpuTimeSupported()
                ? threads.getCurrentThreadCpuTime()
                : System.nanoTime();
    }
}
