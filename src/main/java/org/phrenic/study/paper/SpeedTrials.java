package org.phrenic.study.paper;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/**
 * Measures the paper's table 1: its material and its scheme on one thread, the four cases of a resolution in turn so that whatever else the machine does falls on all of them, the median of some trials.
 * Counted is processor time, which on a machine with nothing else to do is the time on the clock.
 */
final class SpeedTrials {
    /** The paper's scheme, at a step within its stability limit so that an iteration is one step and not several. */
    private static final String[] SCHEME = {"integrator=rk2", "time_step_s=0.0005", "threads=1"};

    private SpeedTrials() {}

    /**
     * Measures one resolution.
     *
     * @param trials of each case
     * @param trialS what a trial takes, s
     */
    static List<SpeedTable.Row> of(Resolution resolution, Thorax thorax, int trials, double trialS) {
        List<Simulation> scenes = new ArrayList<>();
        try {
            for (SpeedCase forces : SpeedCase.values()) {
                scenes.add(Simulation.of(scenario(resolution, forces), thorax));
            }
            int[] steps = new int[scenes.size()];
            for (int i = 0; i < steps.length; i++) {
                perS(scenes.get(i), trialS);
                steps[i] = (int) Math.max(5, trialS * perS(scenes.get(i), trialS));
            }
            List<List<Double>> rates = new ArrayList<>();
            scenes.forEach(scene -> rates.add(new ArrayList<>()));
            for (int trial = 0; trial < trials; trial++) {
                for (int i = 0; i < steps.length; i++) {
                    rates.get(i).add(perS(scenes.get(i), steps[i]));
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

    /** Real time that the paper's material takes up on one thread with the scheme and the step that are used here without being asked: simulated time over processor time. */
    static double realTime(Resolution resolution, Thorax thorax, double trialS) {
        try (Simulation scene =
                Simulation.of(PaperScene.asPublished("deep", resolution).with("threads=1"), thorax)) {
            perS(scene, trialS);
            return perS(scene, trialS) * scene.stepper().dt();
        }
    }

    private static Scenario scenario(Resolution resolution, SpeedCase forces) {
        return PaperScene.asPublished("deep", resolution).with(SCHEME).with(forces.setting());
    }

    /** Steps a second over a stretch of about so many seconds: the warm-up. */
    private static double perS(Simulation simulation, double seconds) {
        long begun = cpuNs();
        int steps = 0;
        do {
            simulation.step();
            steps++;
        } while ((cpuNs() - begun) * 1e-9 < seconds);
        return steps / ((cpuNs() - begun) * 1e-9);
    }

    private static double perS(Simulation simulation, int steps) {
        long begun = cpuNs();
        for (int i = 0; i < steps; i++) {
            simulation.step();
        }
        return steps / ((cpuNs() - begun) * 1e-9);
    }

    private static long cpuNs() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return threads.isCurrentThreadCpuTimeSupported() ? threads.getCurrentThreadCpuTime() : System.nanoTime();
    }
}
