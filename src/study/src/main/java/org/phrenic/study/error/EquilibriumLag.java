package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.document.Key;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.equilibrium.NewtonEquilibrium;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;

/**
 * Distance of a breathing scene from quasi-static equilibrium. The drive (ribs, muscle and pressure) is stopped at a
 * phase of the breath. The nodes then come to rest under the scene's own forces, constraints and viscosity: the
 * equilibrium that the held body takes. From there Newton's method finds an equilibrium of the diaphragm, on which no
 * other structure exerts force ({@link NewtonEquilibrium}); where the sheet is folded, it may be that of another fold.
 * The lungs keep their relaxed positions, because their soft folds have many equilibria.
 *
 * @param timeS time at which the breath was stopped, s
 * @param heldRmsMm rms distance of the diaphragm's nodes from where they come to rest, mm
 * @param heldMaxMm maximum distance of the diaphragm's nodes from where they come to rest, mm
 * @param heldDriftMm rms distance that the diaphragm's nodes still move in the second half of the relaxation, mm
 * @param rmsMm rms distance of the diaphragm's nodes from Newton's equilibrium, mm
 * @param maxMm maximum distance of the diaphragm's nodes from Newton's equilibrium, mm
 * @param relaxedRmsMm rms distance of all nodes from their relaxed positions, mm
 * @param relaxedMaxMm maximum distance of all nodes from their relaxed positions, mm
 * @param relaxationErrorMm rms distance of the relaxed diaphragm from its equilibrium, mm
 * @param newton outcome of Newton's method
 */
public record EquilibriumLag(
        double timeS,
        double heldRmsMm,
        double heldMaxMm,
        double heldDriftMm,
        double rmsMm,
        double maxMm,
        double relaxedRmsMm,
        double relaxedMaxMm,
        @Key("relaxation_left_mm") double relaxationErrorMm,
        NewtonEquilibrium.Result newton) {
    /** Half the relaxation time, s. The slowest modes (about 5 1/s, nearly critically damped) decay to a thousandth. */
    private static final double HALF_S = 2;

    private static final double[] PHASES = {0.15, 0.3, 0.45, 0.75};
    /** Force tolerance, mN: at most 1e-7 of the pressure load on a node. */
    private static final double TOLERANCE_MN = 1e-6;

    private static final int MAX_ROUNDS = 30;

    /** The phases, as shares of a breath. */
    static List<Double> phases() {
        return Arrays.stream(PHASES).boxed().toList();
    }

    /**
     * Computes the lag at several phases of a trajectory.
     *
     * @param phases as shares of the trajectory
     */
    static List<EquilibriumLag> of(BreathRunner runs, Trajectory run, SolverSettings settings, List<Double> phases) {
        List<EquilibriumLag> list = new ArrayList<>();
        ParticleSystem system = runs.simulation().system();
        system.setProjectionSweeps(settings.sweeps());
        boolean[] sheet = runs.diaphragmNodes();
        boolean[] mayMove = new boolean[sheet.length];
        for (int i = 0; i < sheet.length; i++) {
            mayMove[system.layout().caller(i)] = sheet[i];
        }
        int substeps = substeps(runs, run, settings);
        for (double phase : phases) {
            int sample =
                    (int) Math.min(run.positions().length, Math.max(1, Math.round(phase * run.positions().length)));
            double timeS = sample * BreathRunner.SAMPLE_S;
            double[] seen = run.positions()[sample - 1];
            System.arraycopy(seen, 0, system.positions(), 0, seen.length);
            Arrays.fill(system.velocities(), 0);
            system.invalidate();
            Integrator integrator = IntegratorKind.VERLET.create(system);
            hold(integrator, timeS, settings.timeStepS(), substeps);
            Trajectory half = snapshot(system.positions().clone());
            hold(integrator, timeS, settings.timeStepS(), substeps);
            Trajectory relaxed = snapshot(system.positions().clone());
            NewtonEquilibrium.Result newton =
                    new NewtonEquilibrium(system, timeS, mayMove).findEquilibrium(TOLERANCE_MN, MAX_ROUNDS);
            Trajectory rest = snapshot(system.positions());
            double[] all = snapshot(seen).distanceFrom(relaxed);
            double[] distance = snapshot(seen).distanceFrom(rest, sheet);
            double[] held = snapshot(seen).distanceFrom(relaxed, sheet);
            double drift = half.distanceFrom(relaxed, sheet)[0];
            list.add(new EquilibriumLag(
                    timeS,
                    held[0],
                    held[1],
                    drift,
                    distance[0],
                    distance[1],
                    all[0],
                    all[1],
                    relaxed.distanceFrom(rest, sheet)[0],
                    newton));
        }
        return list;
    }

    /** Equal parts of each step of the hold: those of the breath, and those that the scheme of the hold asks for. */
    private static int substeps(BreathRunner runs, Trajectory run, SolverSettings settings) {
        SolverSettings held =
                new SolverSettings(IntegratorKind.VERLET, settings.timeStepS(), settings.sweeps(), settings.refreshS());
        int needed = runs.substeps(held);
        return settings.integrator() == IntegratorKind.VERLET ? Math.max(needed, run.substeps()) : needed;
    }

    /** Steps whose drive does not move: every part of every step ends at the same time. */
    private static void hold(Integrator integrator, double timeS, double stepS, int substeps) {
        long parts = Math.round(HALF_S / stepS) * substeps;
        double partS = stepS / substeps;
        for (long i = 0; i < parts; i++) {
            integrator.step(timeS - partS, partS);
        }
    }

    private static Trajectory snapshot(double[] positions) {
        return new Trajectory(new double[][] {positions}, 1, 0, 0);
    }
}
