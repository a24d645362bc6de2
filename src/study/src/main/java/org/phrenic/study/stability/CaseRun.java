package org.phrenic.study.stability;

import static org.phrenic.file.Numbers.format;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.file.BadInputException;
import org.phrenic.study.stability.CaseResult.Outcome;

/** Runs one stability case under one integrator and checks its bounds. */
final class CaseRun {
    /** Sampling interval in simulated time, s. */
    static final double SAMPLE_S = 0.05;

    /**
     * Conjugate-gradient iterations per backward Euler step, measured on these scenes. One iteration costs about one
     * force evaluation.
     */
    private static final int EVALUATIONS_PER_IMPLICIT_STEP = 20;

    private static final int MAX_DIVERGENCES = 1000;

    /** Factor on the allowed distance from the reference for backward Euler, which damps unresolved motion. */
    private static final double DISSIPATIVE_FACTOR = 2;

    /** Time after which initial oscillations have decayed, s. The paper's damping has a time constant of 10 s. */
    private static final double TRANSIENT_S = 60;

    /** Largest distance between the ends of breaths that count as periodic, mm. */
    private static final double MAX_REPEAT_MM = 0.1;

    /** Time in which oscillations decay after a step refinement or a restored state, s. */
    private static final double SETTLING_S = 1;

    private final StabilityCase stabilityCase;
    private final StabilityBounds bounds;
    private final IntegratorKind integrator;
    private final ReferenceSolution reference;
    private final StabilityScene scene;
    private final NodeState nodes;
    private final double[] start;
    private final double allowedKinetic;
    private final Map<StabilityMeasure, Double> found = new EnumMap<>(StabilityMeasure.class);

    private int divergences;
    private double[] settledPeriodEnd;
    private double endS;
    private String violation = "";
    private boolean notReturned;
    private boolean stopped;
    private String divergence = "";
    private double divergenceTime = Double.NEGATIVE_INFINITY;
    private String refinement = "";
    private double refinementTime = Double.NEGATIVE_INFINITY;
    private int substeps;

    private CaseRun(
            StabilityCase stabilityCase, IntegratorKind integrator, ReferenceSolution reference, StabilityScene scene) {
        this.stabilityCase = stabilityCase;
        this.integrator = integrator;
        this.reference = reference;
        this.scene = scene;
        bounds = stabilityCase.bounds();
        nodes = new NodeState(scene.system());
        start = nodes.positions().clone();
        substeps = scene.stepper().substeps();
        List.of(StabilityMeasure.SPEED_MM_S, StabilityMeasure.REACH_MM, StabilityMeasure.LINK_ERROR)
                .forEach(m -> found.put(m, 0.0));
        if (reference == null) {
            allowedKinetic = Double.NaN;
        } else {
            // A reference almost at rest is no scale for energy, so at least that of all nodes at 1 mm/s is allowed.
            double mass = 0;
            for (double m : scene.system().masses()) {
                mass += m;
            }
            allowedKinetic = Math.max(reference.maxKinetic(), 0.5 * mass);
            List.of(StabilityMeasure.KINETIC_FACTOR, StabilityMeasure.SHAPE).forEach(m -> found.put(m, 0.0));
        }
    }

    /**
     * Runs a case.
     *
     * @param reference solution of the case; null if it needs none
     * @param durationS requested simulated time, s
     * @param nodeEvaluations budget of force evaluations times nodes; a case that needs more ends early
     */
    static CaseResult of(
            StabilityCase stabilityCase,
            IntegratorKind integrator,
            ReferenceSolution reference,
            double durationS,
            double nodeEvaluations) {
        StabilityScene scene;
        try {
            scene = stabilityCase.factory().create(integrator, 1, durationS);
        } catch (IllegalArgumentException | BadInputException | DivergenceException unmade) {
            Outcome outcome = unmade instanceof DivergenceException ? Outcome.STOPPED : Outcome.REFUSED;
            return CaseResult.unmade(stabilityCase.key(), integrator, outcome, durationS, unmade.getMessage());
        }
        try (scene) {
            CaseRun run = new CaseRun(stabilityCase, integrator, reference, scene);
            try {
                run.advance(durationS, nodeEvaluations);
            } catch (IllegalArgumentException | BadInputException refusedChange) {
                run.stop(refusedChange.getMessage());
            }
            run.finish(durationS);
            return run.result(durationS);
        }
    }

    /** @throws IllegalArgumentException if a change of the scene is refused */
    private void advance(double durationS, double nodeEvaluations) {
        Stepper stepper = scene.stepper();
        int evaluations = integrator == IntegratorKind.BACKWARD_EULER
                ? EVALUATIONS_PER_IMPLICIT_STEP
                : integrator.forceEvaluations();
        double costPerSubstep = evaluations * (double) scene.system().nodeCount();
        double spent = 0;
        long sample = 0;
        boolean over = false;
        while (!over && violation.isEmpty()) {
            sample++;
            double until = Math.min(sample * SAMPLE_S, durationS);
            while (!over && violation.isEmpty() && stepper.time() < until - 1e-9) {
                try {
                    scene.step();
                } catch (DivergenceException diverged) {
                    divergence = diverged.getMessage();
                    divergenceTime = stepper.time();
                    sample(stepper.time());
                    stopped = ++divergences > MAX_DIVERGENCES || !scene.undoLastChange();
                    over = stopped;
                }
                noteRefinement(stepper);
                spent += costPerSubstep * stepper.substeps();
            }
            sample(stepper.time());
            over |= stepper.time() >= durationS - 1e-9 || spent > nodeEvaluations;
        }
    }

    /** Ends the run with a sentence. */
    private void stop(String sentence) {
        divergence = sentence;
        stopped = true;
    }

    private void noteRefinement(Stepper stepper) {
        String reason = stepper.substepRefinementReason();
        if (stepper.substeps() > substeps && !reason.isEmpty()) {
            refinementTime = stepper.time();
            refinement = format("at %.2f s: %s: split into %d substeps", refinementTime, reason, stepper.substeps());
        }
        substeps = stepper.substeps();
    }

    private void sample(double time) {
        double[] positions = nodes.positions();
        double speed = nodes.maxSpeed();
        double reach = NodeState.maxDistance(positions, start);
        double linkError = keepLargest(StabilityMeasure.LINK_ERROR, scene.linkError());
        keepLargest(StabilityMeasure.SPEED_MM_S, speed);
        keepLargest(StabilityMeasure.REACH_MM, reach);
        boolean refinedLately = time < refinementTime + SETTLING_S;
        if (!refinedLately) {
            checkBound(StabilityMeasure.SPEED_MM_S, speed, 1, time);
        }
        if (reference != null) {
            double kinetic = scene.system().kineticEnergy() / allowedKinetic;
            keepLargest(StabilityMeasure.KINETIC_FACTOR, kinetic);
            if (!refinedLately) {
                checkBound(StabilityMeasure.KINETIC_FACTOR, kinetic, 1, time);
            }
        }
        // A node far from its start at the divergence needs some time to return.
        if (!(time < divergenceTime + SETTLING_S)) {
            checkBound(StabilityMeasure.REACH_MM, reach, 1, time);
        }
        if (divergence.isEmpty()) {
            checkBound(StabilityMeasure.LINK_ERROR, linkError, 1, time);
            compareWithReference(positions, time);
        }
        if (!(time < Math.max(divergenceTime, refinementTime) + SETTLING_S)) {
            scene.contactErrors()
                    .forEach((measure, error) -> checkBound(measure, keepLargest(measure, error), 1, time));
        }
        compareWithEarlierPeriod(positions, time);
    }

    private void compareWithReference(double[] positions, double time) {
        double[] expected = reference == null || time > bounds.shapeUntilS() ? null : reference.positionsAt(time);
        if (expected != null) {
            double distance = NodeState.rmsDistance(positions, expected) / Math.max(reference.excursion(), 1);
            double factor = integrator == IntegratorKind.BACKWARD_EULER ? DISSIPATIVE_FACTOR : 1;
            checkBound(StabilityMeasure.SHAPE, keepLargest(StabilityMeasure.SHAPE, distance), factor, time);
        }
    }

    private void compareWithEarlierPeriod(double[] positions, double time) {
        double periodS = stabilityCase.periodS();
        double periods = time / periodS;
        if (periodS == 0 || time <= TRANSIENT_S || Math.abs(periods - Math.rint(periods)) * periodS >= 1e-6) {
            return;
        }
        if (settledPeriodEnd == null) {
            settledPeriodEnd = positions.clone();
        } else {
            double distance = NodeState.maxDistance(positions, settledPeriodEnd);
            keepLargest(StabilityMeasure.REPEAT_MM, distance);
            checkBound(StabilityMeasure.REPEAT_MM, distance, 1, time);
        }
    }

    private void finish(double durationS) {
        endS = scene.stepper().time();
        double distance = NodeState.rmsDistance(nodes.positions(), start);
        found.put(StabilityMeasure.RETURN_MM, distance);
        if (violation.isEmpty() && !stopped && endS >= durationS - 1e-9) {
            checkBound(StabilityMeasure.RETURN_MM, distance, 1, endS);
            // Whatever was undone on the way, the body must come back.
            notReturned = !violation.isEmpty() && !divergence.isEmpty();
        }
        if (violation.isEmpty() && !stopped && bounds.isBounded(StabilityMeasure.DRIFT_MM)) {
            measureDrift();
        }
    }

    /** Stops the breath and compares the rest shape with the initial shape. */
    private void measureDrift() {
        Stepper stepper = scene.stepper();
        scene.stopBreathing();
        double until = stepper.time() + ThoraxScene.SETTLING_S;
        try {
            while (stepper.time() < until - 1e-9) {
                scene.step();
            }
        } catch (DivergenceException diverged) {
            stop(diverged.getMessage());
            return;
        }
        double drift = NodeState.maxDistance(nodes.positions(), start);
        found.put(StabilityMeasure.DRIFT_MM, drift);
        checkBound(StabilityMeasure.DRIFT_MM, drift, 1, stepper.time());
    }

    private double keepLargest(StabilityMeasure measure, double value) {
        return found.merge(measure, value, Math::max);
    }

    /** Records the first violation; NaN violates every bound. */
    private void checkBound(StabilityMeasure measure, double value, double factor, double time) {
        double maximum = bounds.maximum(measure) * factor;
        if (bounds.isBounded(measure) && !(value <= maximum) && violation.isEmpty()) {
            violation = format(
                    "at %.2f s: %s: found %.4g, expected at most %.4g", time, measure.description(), value, maximum);
        }
    }

    private Outcome outcome(String reported) {
        if (!violation.isEmpty()) {
            return notReturned ? Outcome.NOT_RETURNED : Outcome.SILENT_FAILURE;
        }
        if (stopped) {
            return bounds.impossible() ? Outcome.NOTICED : Outcome.STOPPED;
        }
        return reported.isEmpty() ? Outcome.STABLE : Outcome.RECOVERED;
    }

    private CaseResult result(double durationS) {
        String reported = divergence.isEmpty() ? refinement : divergence;
        Outcome outcome = outcome(reported);
        double repeat = found.getOrDefault(StabilityMeasure.REPEAT_MM, Double.NaN);
        if (reported.isEmpty() && repeat > MAX_REPEAT_MM) {
            reported = format(
                    "no breath repeats another: nodes end one up to %.2g mm from where they ended another; stopped,"
                            + " all come to rest within %.2g mm of their start",
                    repeat, found.getOrDefault(StabilityMeasure.DRIFT_MM, Double.NaN));
        }
        String sentence = violation.isEmpty() ? reported : violation;
        Stepper stepper = scene.stepper();
        return new CaseResult(
                stabilityCase.key(),
                integrator,
                outcome,
                sentence,
                durationS,
                endS,
                stepper.dt(),
                stepper.substeps(),
                found);
    }
}
