package org.phrenic.study.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.study.PaperScenarios;

/**
 * Measures the paper's table 1 with the paper's material. The four cases of a resolution are measured in turn, so that
 * other load of the machine affects all of them alike.
 */
public final class SpeedTrials {
    /**
     * The paper's scheme on one thread. The time step is within the stability limit, so an iteration is a single step
     * without substeps.
     */
    public static final List<String> SCHEME = List.of("integrator=rk2", "time_step_s=0.0005", "threads=1");

    private SpeedTrials() {}

    /**
     * Measures one resolution.
     *
     * @param settings scenario assignments: scheme, step, threads
     * @param trials number of trials of each case
     * @param trialS duration of a trial, s
     */
    public static List<SpeedTable.Row> of(
            Resolution resolution, Thorax thorax, List<String> settings, int trials, double trialS) {
        List<Simulation> scenes = new ArrayList<>();
        try {
            for (SpeedCase forces : SpeedCase.values()) {
                scenes.add(Simulation.of(scenario(resolution, settings, forces), thorax));
            }
            List<StepTimer> timers = scenes.stream().map(SpeedTrials::timer).toList();
            int[] steps = new int[scenes.size()];
            for (int i = 0; i < steps.length; i++) {
                timers.get(i).rateOver(trialS);
                steps[i] = (int) Math.max(5, trialS * timers.get(i).rateOver(trialS));
            }
            List<List<Double>> rates = new ArrayList<>();
            scenes.forEach(scene -> rates.add(new ArrayList<>()));
            for (int trial = 0; trial < trials; trial++) {
                for (int i = 0; i < steps.length; i++) {
                    rates.get(i).add(timers.get(i).rate(steps[i]));
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
     * Simulated time over processor time of a scenario, such as the published model with its scheme and time step on
     * one thread.
     */
    public static double realTimeFactor(Scenario scenario, Thorax thorax, double trialS) {
        try (Simulation scene = Simulation.of(scenario, thorax)) {
            StepTimer timer = timer(scene);
            timer.rateOver(trialS);
            return timer.rateOver(trialS) * scene.stepper().dt();
        }
    }

    private static Scenario scenario(Resolution resolution, List<String> settings, SpeedCase forces) {
        return PaperScenarios.publishedModel("deep", resolution)
                .with(settings.toArray(String[]::new))
                .with(forces.setting());
    }

    private static StepTimer timer(Simulation simulation) {
        return new StepTimer(simulation.system().workers().count(), steps -> {
            for (int i = 0; i < steps; i++) {
                simulation.step();
            }
        });
    }
}
