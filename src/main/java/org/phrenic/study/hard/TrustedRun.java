package org.phrenic.study.hard;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;

/** A hard case computed so finely that its energy and shape serve as measure for all integrators: velocity Verlet at an eighth of the case's stable step. */
final class TrustedRun {
    private static final int REFINEMENT = 8;

    private final List<double[]> shapes = new ArrayList<>();
    private final double sampleS;
    private final double endS;
    private double peakKinetic;
    private double excursion;

    private TrustedRun(double sampleS, double endS) {
        this.sampleS = sampleS;
        this.endS = endS;
    }

    /** Runs a case finely; null where its bounds need no such run, or where the case is refused or diverges however finely it is stepped. */
    static TrustedRun of(HardCase hard, double durationS, double sampleS) {
        if (!hard.bounds().needsTrusted()) {
            return null;
        }
        TrustedRun run = new TrustedRun(sampleS, Math.min(durationS, hard.trustedS()));
        try (Trial trial = hard.maker().make(IntegratorKind.VERLET, REFINEMENT, durationS)) {
            Shape shape = new Shape(trial.system());
            double[] start = shape.now().clone();
            long perSample = Math.max(1, Math.round(sampleS / trial.stepper().dt()));
            run.shapes.add(start);
            long samples = Math.round(run.endS / sampleS);
            for (long s = 0; s < samples; s++) {
                for (long i = 0; i < perSample; i++) {
                    trial.step();
                }
                double[] now = shape.now().clone();
                run.shapes.add(now);
                run.peakKinetic = Math.max(run.peakKinetic, trial.system().kineticEnergy());
                run.excursion = Math.max(run.excursion, Shape.rms(now, start));
            }
            return run;
        } catch (IllegalArgumentException | DivergenceException told) {
            return null;
        }
    }

    /** Largest kinetic energy at a sample, µJ. */
    double peakKinetic() {
        return peakKinetic;
    }

    /** Largest rms distance from the start, mm. */
    double excursion() {
        return excursion;
    }

    /** The shape at a time; null where there is none. */
    double[] shapeAt(double time) {
        long index = Math.round(time / sampleS);
        return index >= 0 && index < shapes.size() && Math.abs(index * sampleS - time) < 1e-6
                ? shapes.get((int) index)
                : null;
    }
}
