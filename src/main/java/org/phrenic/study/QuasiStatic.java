package org.phrenic.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;

/**
 * How far a breathing scene is from where it would be if it breathed infinitely slowly: ribs, muscle and pressure are stopped at a phase, and the nodes are let come to rest under the scene's own forces, constraints and
 * viscosity. (A Newton iteration on the same forces stalls where contact begins or ends and where folds snap; the motion itself goes through both.)
 *
 * @param timeS when the breath was stopped, s
 * @param rmsMm distance of all nodes from equilibrium, root of the mean square, mm
 * @param maxMm greatest distance, mm
 * @param driftMm how far nodes still moved in the last tenth of the relaxation, rms mm: what is left of it
 */
public record QuasiStatic(double timeS, double rmsMm, double maxMm, double driftMm) {
    /** The slowest shapes swing at some 5 1/s and are about critically damped: in this time they come to a thousandth. */
    private static final double RELAX_S = 2;

    private static final int PARTS = 10;
    private static final double[] PHASES = {0.15, 0.3, 0.45, 0.75};

    /** Stops the breath of a trajectory at a few phases and relaxes each. */
    static List<QuasiStatic> of(BreathRuns runs, Trajectory run, StepSettings settings) {
        List<QuasiStatic> list = new ArrayList<>();
        ParticleSystem system = runs.simulation().system();
        system.setProjectionSweeps(settings.sweeps());
        for (double phase : PHASES) {
            int sample =
                    (int) Math.min(run.positions().length, Math.max(1, Math.round(phase * run.positions().length)));
            double timeS = sample * BreathRuns.SAMPLE_S;
            double[] seen = run.positions()[sample - 1];
            System.arraycopy(seen, 0, system.positions(), 0, seen.length);
            Arrays.fill(system.velocities(), 0);
            system.forget();
            double[] before = seen.clone();
            Integrator integrator = IntegratorKind.VERLET.on(system);
            long steps = Math.round(RELAX_S / PARTS / settings.timeStepS());
            for (int part = 0; part < PARTS; part++) {
                System.arraycopy(system.positions(), 0, before, 0, before.length);
                for (long i = 0; i < steps; i++) {
                    // Each step ends at the same time: what is driven stands still.
                    integrator.step(timeS - settings.timeStepS(), settings.timeStepS());
                }
            }
            double[] rest = system.positions();
            double[] distance = distance(seen, rest);
            list.add(new QuasiStatic(timeS, distance[0], distance[1], distance(before, rest)[0]));
        }
        return list;
    }

    private static double[] distance(double[] a, double[] b) {
        return new Trajectory(new double[][] {a}, 1, 0, 0).distanceFrom(new Trajectory(new double[][] {b}, 1, 0, 0));
    }
}
