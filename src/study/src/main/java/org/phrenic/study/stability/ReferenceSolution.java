package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;

/**
 * A hard case computed so finely that its energy and shape serve as measure for all integrators: velocity Verlet at an
 * eighth of the case's stable step.
 */
final class ReferenceSolution {
    private static final int REFINEMENT = 8;

    private final List<double[]> shapes = new ArrayList<>();
    private final double sampleS;
    private final double endS;
    private double maxKinetic;
    private double excursion;

    private ReferenceSolution(double sampleS, double endS) {
        this.sampleS = sampleS;
        this.endS = endS;
    }

    /**
     * Runs a case finely; null where its bounds need no such run, or where the case is refused or diverges however
     * finely it is stepped.
     */
    static ReferenceSolution of(StabilityCase hard, double durationS, double sampleS) {
        if (!hard.bounds().needsReference()) {
            return null;
        }
        ReferenceSolution run = new ReferenceSolution(sampleS, Math.min(durationS, hard.referenceS()));
        try (StabilityScene trial = hard.factory().create(IntegratorKind.VERLET, REFINEMENT, durationS)) {
            NodeState shape = new NodeState(trial.system());
            double[] start = shape.positions().clone();
            long perSample = Math.max(1, Math.round(sampleS / trial.stepper().dt()));
            run.shapes.add(start);
            long samples = Math.round(run.endS / sampleS);
            for (long s = 0; s < samples; s++) {
                for (long i = 0; i < perSample; i++) {
                    trial.step();
                }
                double[] now = shape.positions().clone();
                run.shapes.add(now);
                run.maxKinetic = Math.max(run.maxKinetic, trial.system().kineticEnergy());
                run.excursion = Math.max(run.excursion, NodeState.rmsDistance(now, start));
            }
            return run;
        } catch (IllegalArgumentException | DivergenceException told) {
            return null;
        }
    }

    /** Largest kinetic energy at a sample, µJ. */
    double maxKinetic() {
        return maxKinetic;
    }

    /** Largest rms distance from the start, mm. */
    double excursion() {
        return excursion;
    }

    /** The shape at a time; null where there is none. */
    double[] positionsAt(double time) {
        long index = Math.round(time / sampleS);
        return index >= 0 && index < shapes.size() && Math.abs(index * sampleS - time) < 1e-6
                ? shapes.get((int) index)
                : null;
    }
}
