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
 * Distance of a breathing scene from quasi-static equilibrium: ribs, muscle and pressure are stopped at a phase, the
 * nodes are let come near rest under the scene's own forces, constraints and viscosity, and from there Newton's method
 * finds the equilibrium of the diaphragm, which nothing else in the scene pulls on ({@link NewtonEquilibrium}). Lungs
 * are left where the relaxation brought them: their soft folds have many equilibria.
 *
 * @param timeS when the breath was stopped, s
 * @param rmsMm distance of the diaphragm's nodes from equilibrium, root of the mean square, mm
 * @param maxMm greatest distance, mm
 * @param relaxedRmsMm distance of all nodes from where the relaxation brought them, rms mm
 * @param relaxedMaxMm greatest, mm
 * @param relaxationErrorMm how far from the equilibrium the relaxation had left the diaphragm, rms mm
 * @param newton how Newton's method went
 */
public record EquilibriumLag(
        double timeS,
        double rmsMm,
        double maxMm,
        double relaxedRmsMm,
        double relaxedMaxMm,
        @Key("relaxation_left_mm") double relaxationErrorMm,
        NewtonEquilibrium.Result newton) {
    /** The slowest modes have some 5 1/s and are about critically damped: in this time they decay to a thousandth. */
    private static final double RELAX_S = 2;

    private static final double[] PHASES = {0.15, 0.3, 0.45, 0.75};
    /** A ten-millionth of the load of pressure on a node, and less. */
    private static final double TOLERANCE_MN = 1e-6;

    private static final int MAX_ROUNDS = 30;

    /** Stops the breath of a trajectory at a few phases and finds the equilibrium of each. */
    static List<EquilibriumLag> of(BreathRunner runs, Trajectory run, SolverSettings settings) {
        List<EquilibriumLag> list = new ArrayList<>();
        ParticleSystem system = runs.simulation().system();
        system.setProjectionSweeps(settings.sweeps());
        boolean[] sheet = runs.diaphragmNodes();
        boolean[] mayMove = new boolean[sheet.length];
        for (int i = 0; i < sheet.length; i++) {
            mayMove[system.layout().caller(i)] = sheet[i];
        }
        for (double phase : PHASES) {
            int sample =
                    (int) Math.min(run.positions().length, Math.max(1, Math.round(phase * run.positions().length)));
            double timeS = sample * BreathRunner.SAMPLE_S;
            double[] seen = run.positions()[sample - 1];
            System.arraycopy(seen, 0, system.positions(), 0, seen.length);
            Arrays.fill(system.velocities(), 0);
            system.invalidate();
            Integrator integrator = IntegratorKind.VERLET.create(system);
            long steps = Math.round(RELAX_S / settings.timeStepS());
            for (long i = 0; i < steps; i++) {
                // Each step ends at the same time: what is driven stands still.
                integrator.step(timeS - settings.timeStepS(), settings.timeStepS());
            }
            Trajectory relaxed = snapshot(system.positions().clone());
            NewtonEquilibrium.Result newton =
                    new NewtonEquilibrium(system, timeS, mayMove).findEquilibrium(TOLERANCE_MN, MAX_ROUNDS);
            Trajectory rest = snapshot(system.positions());
            double[] all = snapshot(seen).distanceFrom(relaxed);
            double[] distance = snapshot(seen).distanceFrom(rest, sheet);
            list.add(new EquilibriumLag(
                    timeS, distance[0], distance[1], all[0], all[1], relaxed.distanceFrom(rest, sheet)[0], newton));
        }
        return list;
    }

    private static Trajectory snapshot(double[] positions) {
        return new Trajectory(new double[][] {positions}, 1, 0, 0);
    }
}
