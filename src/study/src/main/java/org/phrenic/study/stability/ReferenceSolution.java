package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;

/** Reference solution of a stability case: velocity Verlet at an eighth of its stable step. */
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

    /** Solves a case; null if its bounds need no reference, or if the case is refused or diverges at this step. */
    static ReferenceSolution of(StabilityCase stabilityCase, double durationS, double sampleS) {
        if (!stabilityCase.bounds().needsReference()) {
            return null;
        }
        ReferenceSolution run = new ReferenceSolution(sampleS, Math.min(durationS, stabilityCase.referenceS()));
        try (StabilityScene scene = stabilityCase.factory().create(IntegratorKind.VERLET, REFINEMENT, durationS)) {
            NodeState nodes = new NodeState(scene.system());
            double[] start = nodes.positions().clone();
            long perSample = Math.max(1, Math.round(sampleS / scene.stepper().dt()));
            run.shapes.add(start);
            long samples = Math.round(run.endS / sampleS);
            for (long s = 0; s < samples; s++) {
                for (long i = 0; i < perSample; i++) {
                    scene.step();
                    // A node that the wall puts back moves for a step or two, mostly between two samples.
                    run.maxKinetic = Math.max(run.maxKinetic, scene.system().kineticEnergy());
                }
                double[] now = nodes.positions().clone();
                run.shapes.add(now);
                run.excursion = Math.max(run.excursion, NodeState.rmsDistance(now, start));
            }
            return run;
        } catch (IllegalArgumentException | DivergenceException unsolvable) {
            return null;
        }
    }

    /** Largest kinetic energy after a step, µJ. */
    double maxKinetic() {
        return maxKinetic;
    }

    /** Largest rms distance from the start, mm. */
    double excursion() {
        return excursion;
    }

    /** Positions at a sampling time; null at other times. */
    double[] positionsAt(double time) {
        long index = Math.round(time / sampleS);
        return index >= 0 && index < shapes.size() && Math.abs(index * sampleS - time) < 1e-6
                ? shapes.get((int) index)
                : null;
    }
}
