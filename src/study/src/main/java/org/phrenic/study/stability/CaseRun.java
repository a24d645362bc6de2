package org.phrenic.study.stability;

import java.util.Locale;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.Stepper;

/** Runs one hard case under one integrator and judges it. */
final class CaseRun {
    /** Between looks at the scene, s of simulated time. */
    static final double SAMPLE_S = 0.05;

    /**
     * Conjugate-gradient iterations of a backward Euler step, each about a force evaluation: as measured on these
     * scenes.
     */
    private static final int EVALUATIONS_PER_IMPLICIT_STEP = 20;

    /** After so many a scene is given up, with a good state put back. */
    private static final int MAX_DIVERGENCES = 1000;

    /** Backward Euler damps what it does not resolve: it may be so many times as far from the trusted shape. */
    private static final double DISSIPATIVE_FACTOR = 2;

    /** By then the swing of the start has died down, s: with the paper's damping it fades by e in 10 s. */
    private static final double TRANSIENT_S = 60;

    /** Breaths that end farther apart do not repeat each other, mm. */
    private static final double MAX_REPEAT_MM = 0.1;

    /**
     * What had begun to swing when a step was split, or was on its way out when a state was put back, has so long to
     * die down, s.
     */
    private static final double SETTLING_S = 1;

    private final StabilityCase hard;
    private final IntegratorKind kind;
    private final ReferenceSolution reference;
    private final StabilityScene trial;
    private final NodeState shape;
    private final double[] start;
    private final double allowedKinetic;

    private int divergences;
    private double maxKinetic;
    private double maxSpeed;
    private double maxDistance;
    private double maxShapeError;
    private double maxLinkError;
    private double[] settledPeriodEnd;
    private double repeat = Double.NaN;
    private double drift = Double.NaN;
    private double returnDistance;
    private double endS;
    private String violation = "";
    private String divergence = "";
    private double divergenceTime = Double.NEGATIVE_INFINITY;
    private String refinement = "";
    private double refinementTime = Double.NEGATIVE_INFINITY;
    private int substeps;

    private CaseRun(StabilityCase hard, IntegratorKind kind, ReferenceSolution trusted, StabilityScene trial) {
        this.hard = hard;
        this.kind = kind;
        this.reference = trusted;
        this.trial = trial;
        shape = new NodeState(trial.system());
        start = shape.positions().clone();
        substeps = trial.stepper().substeps();
        // A trusted run that hardly moves says nothing about energy: as much as all nodes at 1 mm/s is then allowed.
        double mass = 0;
        for (double m : trial.system().masses()) {
            mass += m;
        }
        allowedKinetic = trusted == null ? Double.NaN : Math.max(trusted.maxKinetic(), 0.5 * mass);
    }

    /**
     * Runs a cell.
     *
     * @param trusted measure of the case; null where it needs none
     * @param durationS simulated time asked for, s
     * @param nodeEvaluations evaluations of the force on a node that may be spent; a cell that needs more ends earlier,
     *     which its simulated time shows
     */
    static CaseResult of(
            StabilityCase hard,
            IntegratorKind kind,
            ReferenceSolution trusted,
            double durationS,
            double nodeEvaluations) {
        StabilityScene trial;
        try {
            trial = hard.factory().create(kind, 1, durationS);
        } catch (IllegalArgumentException refused) {
            return CaseResult.refused(hard, kind, durationS, refused.getMessage());
        }
        try (trial) {
            CaseRun run = new CaseRun(hard, kind, trusted, trial);
            String refused = run.advance(durationS, nodeEvaluations);
            return refused.isEmpty() ? run.result(durationS) : CaseResult.refused(hard, kind, durationS, refused);
        }
    }

    /** Steps to the end, looking every so often; returns the sentence if the scene was refused on the way. */
    private String advance(double durationS, double nodeEvaluations) {
        Stepper stepper = trial.stepper();
        double spent = 0;
        double step = (kind == IntegratorKind.BACKWARD_EULER ? EVALUATIONS_PER_IMPLICIT_STEP : kind.forceEvaluations())
                * (double) trial.system().nodeCount();
        long sample = 0;
        boolean over = false;
        while (!over && violation.isEmpty()) {
            sample++;
            double until = Math.min(sample * SAMPLE_S, durationS);
            while (!over && violation.isEmpty() && stepper.time() < until - 1e-9) {
                try {
                    trial.step();
                } catch (DivergenceException told) {
                    divergence = told.getMessage();
                    divergenceTime = stepper.time();
                    sample(stepper.time());
                    over = ++divergences > MAX_DIVERGENCES || !trial.undoLastChange();
                } catch (IllegalArgumentException refused) {
                    return refused.getMessage();
                }
                if (stepper.substeps() > substeps
                        && !stepper.substepRefinementReason().isEmpty()) {
                    refinementTime = stepper.time();
                    refinement = String.format(
                            Locale.ROOT,
                            "at %.2f s: %s: split into %d substeps",
                            refinementTime,
                            stepper.substepRefinementReason(),
                            stepper.substeps());
                }
                substeps = stepper.substeps();
                spent += step * stepper.substeps();
            }
            sample(stepper.time());
            over |= stepper.time() >= durationS - 1e-9 || spent > nodeEvaluations;
        }
        finish(durationS);
        return "";
    }

    private void sample(double time) {
        double kinetic = trial.system().kineticEnergy();
        double fastest = shape.maxSpeed();
        double[] now = shape.positions();
        maxKinetic = Math.max(maxKinetic, kinetic);
        maxSpeed = Math.max(maxSpeed, fastest);
        double farthest = NodeState.maxDistance(now, start);
        maxDistance = Math.max(maxDistance, farthest);
        maxLinkError = Math.max(maxLinkError, trial.linkError());
        StabilityBounds bounds = hard.bounds();
        if (!(time < refinementTime + SETTLING_S)) {
            checkBound("speed of a node, mm/s", fastest, bounds.speedMmS(), time);
            if (reference != null) {
                checkBound(
                        "kinetic energy over that of the trusted run",
                        kinetic / allowedKinetic,
                        bounds.kineticFactor(),
                        time);
            }
        }
        // What was noticed far out may go on for a moment before it turns round.
        if (!(time < divergenceTime + SETTLING_S)) {
            checkBound("distance of a node from its start, mm", farthest, bounds.reachMm(), time);
        }
        if (divergence.isEmpty()) {
            checkBound("error of a link's length", maxLinkError, bounds.linkError(), time);
        }
        boolean comparable = reference != null && divergence.isEmpty() && time <= bounds.shapeS();
        double[] right = comparable ? reference.positionsAt(time) : null;
        if (right != null) {
            maxShapeError =
                    Math.max(maxShapeError, NodeState.rmsDistance(now, right) / Math.max(reference.excursion(), 1));
            double most = bounds.shape() * (kind == IntegratorKind.BACKWARD_EULER ? DISSIPATIVE_FACTOR : 1);
            checkBound("rms distance from the trusted run over its excursion", maxShapeError, most, time);
        }
        if (hard.periodS() > 0) {
            double periods = time / hard.periodS();
            if (Math.abs(periods - Math.rint(periods)) * hard.periodS() < 1e-6 && time > TRANSIENT_S) {
                if (settledPeriodEnd == null) {
                    settledPeriodEnd = now.clone();
                } else {
                    double apart = NodeState.maxDistance(now, settledPeriodEnd);
                    repeat = Double.isNaN(repeat) ? apart : Math.max(repeat, apart);
                    checkBound(
                            "distance of a node from where an earlier breath left it, mm",
                            apart,
                            bounds.repeatMm(),
                            time);
                }
            }
        }
    }

    private void finish(double durationS) {
        endS = trial.stepper().time();
        returnDistance = NodeState.rmsDistance(shape.positions(), start);
        if (violation.isEmpty() && divergence.isEmpty() && endS >= durationS - 1e-9) {
            checkBound(
                    "rms distance from the start at the end, mm",
                    returnDistance,
                    hard.bounds().returnMm(),
                    endS);
        }
        if (violation.isEmpty() && hard.bounds().driftMm() < Double.POSITIVE_INFINITY) {
            measureDrift();
        }
    }

    /** Stops the breath and holds the shape in which the body comes to rest against that of its start. */
    private void measureDrift() {
        Stepper stepper = trial.stepper();
        trial.stopBreathing();
        double until = stepper.time() + BreathStop.SETTLING_S;
        try {
            while (stepper.time() < until - 1e-9) {
                trial.step();
            }
        } catch (DivergenceException told) {
            divergence = told.getMessage();
            return;
        }
        drift = NodeState.maxDistance(shape.positions(), start);
        checkBound("drift of a node of the rest shape, mm", drift, hard.bounds().driftMm(), stepper.time());
    }

    /**
     * A number that is none is within nothing; where no trusted run is asked for, nothing is asked of what needs it.
     */
    private void checkBound(String what, double found, double most, double time) {
        if (most < Double.POSITIVE_INFINITY && !(found <= most) && violation.isEmpty()) {
            violation = String.format(
                    Locale.ROOT, "at %.2f s: %s: found %.4g, expected at most %.4g", time, what, found, most);
        }
    }

    private CaseResult result(double durationS) {
        String told = divergence.isEmpty() ? refinement : divergence;
        CaseOutcome verdict = !violation.isEmpty()
                ? CaseOutcome.SILENT_FAILURE
                : told.isEmpty() ? CaseOutcome.STABLE : CaseOutcome.RECOVERED;
        if (told.isEmpty() && repeat > MAX_REPEAT_MM) {
            told = String.format(
                    Locale.ROOT,
                    "no breath repeats another: nodes end one up to %.2g mm from where they ended another; stopped,"
                            + " all come to rest within %.2g mm of their start",
                    repeat,
                    drift);
        }
        return new CaseResult(
                hard.key(),
                kind,
                verdict,
                violation.isEmpty() ? told : violation,
                durationS,
                endS,
                trial.stepper().dt(),
                trial.stepper().substeps(),
                reference == null ? Double.NaN : maxKinetic / allowedKinetic,
                maxSpeed,
                maxDistance,
                reference == null ? Double.NaN : maxShapeError,
                maxLinkError,
                returnDistance,
                repeat,
                drift);
    }
}
