package org.phrenic.study.error;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;

/**
 * Grid of solver settings to measure. Crossed: all combinations of integrator, time step, sweeps and refresh interval.
 * Otherwise all combinations of integrator and time step with the scenario's sweeps and refresh interval, and all
 * combinations of sweeps and refresh interval with the scenario's integrator and time step.
 *
 * @param integrators schemes
 * @param timeStepsS time steps, s; each divides {@link BreathRunner#SAMPLE_S}
 * @param sweeps numbers of constraint sweeps per step
 * @param refreshesS refresh intervals of anchors and wall planes, s
 * @param isCrossed whether all combinations are measured
 */
public record SolverGrid(
        List<IntegratorKind> integrators,
        List<Double> timeStepsS,
        List<Integer> sweeps,
        List<Double> refreshesS,
        boolean isCrossed) {
    /** Each sweep halves the constraint residual, so eight leave about 1/250. */
    private static final int REFERENCE_SWEEPS = 8;

    /** Number of steps between refreshes of anchors and wall planes in the reference. */
    private static final int REFERENCE_REFRESH = 2;

    private static final double PHYSICAL_REFINEMENT = 8;
    private static final double SMOOTH_REFINEMENT = 10;

    /** Relative difference from a whole number of steps that is rounding. */
    private static final double ROUNDING = 1e-9;

    /**
     * A grid.
     *
     * @throws BadInputException if a time step does not divide the sampling interval: samples of two runs at different
     *     times would differ by the motion between them
     */
    public SolverGrid {
        for (double step : timeStepsS) {
            double steps = BreathRunner.SAMPLE_S / step;
            if (Math.abs(steps - Math.round(steps)) > ROUNDING * steps) {
                throw new BadInputException("time step of an error study: found " + step
                        + " s, expected one that divides " + BreathRunner.SAMPLE_S + " s, such as 0.00125");
            }
        }
    }

    /** Settings of a convergence study: constraints swept to convergence and planes refreshed at a fixed interval. */
    static SolverSettings converged(IntegratorKind scheme, double stepS, double refreshS) {
        return new SolverSettings(scheme, stepS, REFERENCE_SWEEPS, refreshS);
    }

    /** Nothing besides the scenario's own setting. */
    static SolverGrid own(Scenario scenario) {
        return ofIntegrators(List.of(), scenario);
    }

    /** Every integrator with the scenario's own step, sweeps and refresh interval. */
    static SolverGrid integrators(Scenario scenario) {
        return ofIntegrators(List.of(IntegratorKind.values()), scenario);
    }

    private static SolverGrid ofIntegrators(List<IntegratorKind> integrators, Scenario scenario) {
        SolverSettings own = SolverSettings.of(scenario);
        return new SolverGrid(
                integrators, List.of(own.timeStepS()), List.of(own.sweeps()), List.of(own.refreshS()), true);
    }

    /** The settings of a material from which users choose. */
    public static SolverGrid of(TissueMaterial material) {
        List<IntegratorKind> all = List.of(IntegratorKind.values());
        return material == Materials.PHYSICAL
                ? new SolverGrid(
                        all, List.of(0.000625, 0.00125, 0.0025, 0.02), List.of(1, 2, 3, 8), List.of(0.02, 0.005), false)
                : new SolverGrid(
                        all, List.of(0.0025, 0.005, 0.01, 0.0125, 0.02), List.of(1), List.of(0.04, 0.02, 0.005), false);
    }

    /** A small grid that runs in seconds. */
    public static SolverGrid quick(TissueMaterial material) {
        return new SolverGrid(
                List.of(IntegratorKind.VERLET, IntegratorKind.SYMPLECTIC_EULER),
                material == Materials.PHYSICAL ? List.of(0.00125) : List.of(0.005, 0.01),
                List.of(1, 2),
                List.of(0.02),
                true);
    }

    /** All settings, including the scenario's own. */
    List<SolverSettings> settings(Scenario scenario) {
        SolverSettings own = SolverSettings.of(scenario);
        Set<SolverSettings> list = new LinkedHashSet<>();
        if (!isCrossed) {
            addCombinations(integrators, timeStepsS, List.of(own.sweeps()), List.of(own.refreshS()), list);
            addCombinations(List.of(own.integrator()), List.of(own.timeStepS()), sweeps, refreshesS, list);
        } else {
            addCombinations(integrators, timeStepsS, sweeps, refreshesS, list);
        }
        list.add(own);
        return List.copyOf(list);
    }

    private static void addCombinations(
            List<IntegratorKind> integrators,
            List<Double> steps,
            List<Integer> sweeps,
            List<Double> refreshes,
            Set<SolverSettings> list) {
        for (double refresh : refreshes) {
            for (IntegratorKind integrator : integrators) {
                for (double step : steps) {
                    sweeps.forEach(sweep -> list.add(new SolverSettings(integrator, step, sweep, refresh)));
                }
            }
        }
    }

    /**
     * Settings of the reference solution: constraints swept to convergence, anchors and wall planes refreshed every
     * second step. Physical material: velocity Verlet with an eighth of the scenario's step, because contact leaves no
     * scheme more than order 1 and Verlet asks for one force evaluation a step. Otherwise the fourth-order scheme with
     * a tenth of the step.
     *
     * @param coarsening factor of the time step: 1, or 2 for the solution that tells the reference's uncertainty
     */
    static SolverSettings reference(Scenario scenario, int coarsening) {
        boolean contact = scenario.material() == Materials.PHYSICAL;
        double step = coarsening * scenario.timeStepS() / (contact ? PHYSICAL_REFINEMENT : SMOOTH_REFINEMENT);
        return new SolverSettings(
                contact ? IntegratorKind.VERLET : IntegratorKind.RK4, step, REFERENCE_SWEEPS, REFERENCE_REFRESH * step);
    }
}
