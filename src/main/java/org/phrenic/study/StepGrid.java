package org.phrenic.study;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.simulation.Material;
import org.phrenic.simulation.Scenario;

/**
 * Which settings are measured: every integrator with every step, sweep and refresh of a list. The lists are those of the material unless others are given.
 *
 * @param integrators schemes
 * @param timeStepsS steps, s; each goes a whole number of times into {@link BreathRuns#SAMPLE_S}
 * @param sweeps over all constraints a step
 * @param refreshesS between anchors and wall planes taken anew, s
 */
public record StepGrid(
        List<IntegratorKind> integrators, List<Double> timeStepsS, List<Integer> sweeps, List<Double> refreshesS) {
    /** Each sweep halves what the last one left: of eight about a 250th is left. */
    private static final int REFERENCE_SWEEPS = 8;

    /** Steps of the reference between anchors and wall planes taken anew. */
    private static final int REFERENCE_REFRESH = 2;

    /** All that a material's front is chosen from. */
    public static StepGrid of(Material material) {
        List<IntegratorKind> all = List.of(IntegratorKind.values());
        return material == Material.PHYSICAL
                ? new StepGrid(
                        all,
                        List.of(0.0005, 0.001, 0.00125, 0.002, 0.005, 0.01, 0.02),
                        List.of(1, 2, 4, 8),
                        List.of(0.02, 0.005, 0.002))
                : new StepGrid(
                        all,
                        List.of(0.0025, 0.005, 1.0 / 140, 0.01, 0.0125, 0.02, 0.05),
                        List.of(1),
                        List.of(0.04, 0.02, 0.005));
    }

    /** A few settings that take seconds. */
    public static StepGrid quick(Material material) {
        return new StepGrid(
                List.of(IntegratorKind.VERLET, IntegratorKind.SYMPLECTIC_EULER),
                material == Material.PHYSICAL ? List.of(0.00125) : List.of(0.005, 0.01),
                List.of(1, 2),
                List.of(0.02));
    }

    /** The settings, refresh by refresh, and what a scenario has by itself among them. */
    List<StepSettings> settings(Scenario scenario) {
        Set<StepSettings> list = new LinkedHashSet<>();
        StepSettings own = StepSettings.of(scenario);
        List<Double> refreshes = new ArrayList<>(new LinkedHashSet<>(refreshesS));
        if (!refreshes.contains(own.refreshS())) {
            list.add(own);
        }
        for (double refresh : refreshes) {
            if (refresh == own.refreshS()) {
                list.add(own);
            }
            for (IntegratorKind integrator : integrators) {
                for (double step : timeStepsS) {
                    for (int sweep : sweeps) {
                        list.add(new StepSettings(integrator, step, sweep, refresh));
                    }
                }
            }
        }
        return List.copyOf(list);
    }

    /** The reference with a step: fourth order, constraints swept until they agree, anchors and walls taken anew every other step. */
    static StepSettings reference(double stepS) {
        return new StepSettings(IntegratorKind.RK4, stepS, REFERENCE_SWEEPS, REFERENCE_REFRESH * stepS);
    }

    /** Step of the finest reference of a material, s. */
    static double referenceStepS(Material material) {
        return material == Material.PHYSICAL ? 0.0005 : 0.001;
    }
}
