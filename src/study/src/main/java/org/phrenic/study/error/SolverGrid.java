package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;

/**
 * Which settings are measured: every integrator with every step, sweep and refresh of a list. The lists are those of
 * the material unless others are given.
 *
 * @param integrators schemes
 * @param timeStepsS steps, s; each goes a whole number of times into {@link BreathRunner#SAMPLE_S}
 * @param sweeps over all constraints a step
 * @param refreshesS refresh intervals of anchors and wall planes, s
 */
public record SolverGrid(
        List<IntegratorKind> integrators, List<Double> timeStepsS, List<Integer> sweeps, List<Double> refreshesS) {
    /** Each sweep halves what the last one left: of eight about a 250th is left. */
    private static final int REFERENCE_SWEEPS = 8;

    /** Steps of the reference between refreshes of anchors and wall planes. */
    private static final int REFERENCE_REFRESH = 2;

    /** All that a material's front is chosen from. */
    public static SolverGrid of(TissueMaterial material) {
        List<IntegratorKind> all = List.of(IntegratorKind.values());
        return material == Materials.PHYSICAL
                ? new SolverGrid(
                        all,
                        List.of(0.0005, 0.001, 0.00125, 0.002, 0.005, 0.01, 0.02),
                        List.of(1, 2, 4, 8),
                        List.of(0.02, 0.005, 0.002))
                : new SolverGrid(
                        all,
                        List.of(0.0025, 0.005, 1.0 / 140, 0.01, 0.0125, 0.02, 0.05),
                        List.of(1),
                        List.of(0.04, 0.02, 0.005));
    }

    /** A few settings that take seconds. */
    public static SolverGrid quick(TissueMaterial material) {
        return new SolverGrid(
                List.of(IntegratorKind.VERLET, IntegratorKind.SYMPLECTIC_EULER),
                material == Materials.PHYSICAL ? List.of(0.00125) : List.of(0.005, 0.01),
                List.of(1, 2),
                List.of(0.02));
    }

    /** The settings, refresh by refresh, and what a scenario has by itself among them. */
    List<SolverSettings> settings(Scenario scenario) {
        Set<SolverSettings> list = new LinkedHashSet<>();
        SolverSettings own = SolverSettings.of(scenario);
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
                        list.add(new SolverSettings(integrator, step, sweep, refresh));
                    }
                }
            }
        }
        return List.copyOf(list);
    }

    /**
     * The reference with a step: fourth order, constraints swept to convergence, anchors and walls refreshed every
     * other step.
     */
    static SolverSettings reference(double stepS) {
        return new SolverSettings(IntegratorKind.RK4, stepS, REFERENCE_SWEEPS, REFERENCE_REFRESH * stepS);
    }

    /** Step of the finest reference of a material, s. */
    static double referenceStepS(TissueMaterial material) {
        return material == Materials.PHYSICAL ? 0.0005 : 0.001;
    }
}
