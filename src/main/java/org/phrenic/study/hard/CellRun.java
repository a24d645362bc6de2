package org.phrenic.study.hard;

import java.util.Locale;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.Stepper;

/** Runs one hard case under one integrator and judges it. */
final class CellRun {
    /** Between looks at the scene, s of simulated time. */
    static final double SAMPLE_S = 0.05;

    /** Conjugate-gradient iterations of a backward Euler step, each about a force evaluation: as measured on these scenes. */
    private static final int IMPLICIT_COST = 20;

    /** After so many a scene is given up, with a good state put back. */
    private static final int MOST_DIVERGENCES = 1000;

    /** Backward Euler damps what it does not resolve: it may be so many times as far from the trusted shape. */
    private static final double DISSIPATIVE = 2;

    /** By then the swing of the start has died down, s: with the paper's damping it fades by e in 10 s. */
    private static final double TRANSIENT_S = 60;

    /** Breaths that end farther apart do not repeat each other, mm. */
    private static final double UNLIKE_MM = 0.1;

    /** What had begun to swing when a step was split, or was on its way out when a state was put back, has so long to die down, s. */
    private static final double SETTLES_S = 1;

    private final HardCase hard;
    private final IntegratorKind kind;
    private final TrustedRun trusted;
    private final Trial trial;
    private final Shape shape;
    private final double[] start;
    private final double peakAllowed;

    private int divergences;
    private double peak;
    private double speed;
    private double reach;
    private double parted;
    private double links;
    private double[] settledPeriodEnd;
    private double repeat = Double.NaN;
    private double drift = Double.NaN;
    private double returned;
    private double endS;
    private String breach = "";
    private String noticed = "";
    private double noticedTime = Double.NEGATIVE_INFINITY;
    private String split = "";
    private double splitTime = Double.NEGATIVE_INFINITY;
    private int substeps;

    private CellRun(HardCase hard, IntegratorKind kind, TrustedRun trusted, Trial trial) {
        this.hard = hard;
        this.kind = kind;
        this.trusted = trusted;
        this.trial = trial;
        shape = new Shape(trial.system());
        start = shape.now().clone();
        substeps = trial.stepper().substeps();
        // A trusted run that hardly moves says nothing about energy: as much as all nodes at 1 mm/s is then allowed.
        double mass = 0;
        for (double m : trial.system().masses()) {
            mass += m;
        }
        peakAllowed = trusted == null ? Double.NaN : Math.max(trusted.peakKinetic(), 0.5 * mass);
    }

    /**
     * Runs a cell.
     *
     * @param trusted measure of the case; null where it needs none
     * @param durationS simulated time asked for, s
     * @param nodeEvaluations evaluations of the force on a node that may be spent; a cell that needs more ends earlier, which its simulated time shows
     */
    static Cell of(HardCase hard, IntegratorKind kind, TrustedRun trusted, double durationS, double nodeEvaluations) {
        Trial trial;
        try {
            trial = hard.maker().make(kind, 1, durationS);
        } catch (IllegalArgumentException refused) {
            return Cell.refused(hard, kind, durationS, refused.getMessage());
        }
        try (trial) {
            CellRun run = new CellRun(hard, kind, trusted, trial);
            String refused = run.advance(durationS, nodeEvaluations);
            return refused.isEmpty() ? run.cell(durationS) : Cell.refused(hard, kind, durationS, refused);
        }
    }

    /** Steps to the end, looking every so often; returns the sentence if the scene was refused on the way. */
    private String advance(double durationS, double nodeEvaluations) {
        Stepper stepper = trial.stepper();
        double spent = 0;
        double step = (kind == IntegratorKind.BACKWARD_EULER ? IMPLICIT_COST : kind.forceEvaluations())
                * (double) trial.system().nodeCount();
        long sample = 0;
        boolean over = false;
        while (!over && breach.isEmpty()) {
            sample++;
            double until = Math.min(sample * SAMPLE_S, durationS);
            while (!over && breach.isEmpty() && stepper.time() < until - 1e-9) {
                try {
                    trial.step();
                } catch (DivergenceException told) {
                    noticed = told.getMessage();
                    noticedTime = stepper.time();
                    look(stepper.time());
                    over = ++divergences > MOST_DIVERGENCES || !trial.takeBack();
                } catch (IllegalArgumentException refused) {
                    return refused.getMessage();
                }
                if (stepper.substeps() > substeps && !stepper.finerWhy().isEmpty()) {
                    splitTime = stepper.time();
                    split = String.format(
                            Locale.ROOT,
                            "at %.2f s: %s: split into %d substeps",
                            splitTime,
                            stepper.finerWhy(),
                            stepper.substeps());
                }
                substeps = stepper.substeps();
                spent += step * stepper.substeps();
            }
            look(stepper.time());
            over |= stepper.time() >= durationS - 1e-9 || spent > nodeEvaluations;
        }
        end(durationS);
        return "";
    }

    private void look(double time) {
        double kinetic = trial.system().kineticEnergy();
        double fastest = shape.fastest();
        double[] now = shape.now();
        peak = Math.max(peak, kinetic);
        speed = Math.max(speed, fastest);
        double farthest = Shape.farthest(now, start);
        reach = Math.max(reach, farthest);
        links = Math.max(links, trial.linkError());
        Bounds bounds = hard.bounds();
        if (!(time < splitTime + SETTLES_S)) {
            within("speed of a node, mm/s", fastest, bounds.speedMmS(), time);
            if (trusted != null) {
                within(
                        "kinetic energy over that of the trusted run",
                        kinetic / peakAllowed,
                        bounds.kineticFactor(),
                        time);
            }
        }
        // What was noticed far out may go on for a moment before it turns round.
        if (!(time < noticedTime + SETTLES_S)) {
            within("distance of a node from its start, mm", farthest, bounds.reachMm(), time);
        }
        if (noticed.isEmpty()) {
            within("error of a link's length", links, bounds.linkError(), time);
        }
        boolean comparable = trusted != null && noticed.isEmpty() && time <= bounds.shapeS();
        double[] right = comparable ? trusted.shapeAt(time) : null;
        if (right != null) {
            parted = Math.max(parted, Shape.rms(now, right) / Math.max(trusted.excursion(), 1));
            double most = bounds.shape() * (kind == IntegratorKind.BACKWARD_EULER ? DISSIPATIVE : 1);
            within("rms distance from the trusted run over its excursion", parted, most, time);
        }
        if (hard.periodS() > 0) {
            double periods = time / hard.periodS();
            if (Math.abs(periods - Math.rint(periods)) * hard.periodS() < 1e-6 && time > TRANSIENT_S) {
                if (settledPeriodEnd == null) {
                    settledPeriodEnd = now.clone();
                } else {
                    double apart = Shape.farthest(now, settledPeriodEnd);
                    repeat = Double.isNaN(repeat) ? apart : Math.max(repeat, apart);
                    within(
                            "distance of a node from where an earlier breath left it, mm",
                            apart,
                            bounds.repeatMm(),
                            time);
                }
            }
        }
    }

    private void end(double durationS) {
        endS = trial.stepper().time();
        returned = Shape.rms(shape.now(), start);
        if (breach.isEmpty() && noticed.isEmpty() && endS >= durationS - 1e-9) {
            within(
                    "rms distance from the start at the end, mm",
                    returned,
                    hard.bounds().returnMm(),
                    endS);
        }
        if (breach.isEmpty() && hard.bounds().driftMm() < Double.POSITIVE_INFINITY) {
            rest();
        }
    }

    /** Stops the breath and holds the shape in which the body comes to rest against that of its start. */
    private void rest() {
        Stepper stepper = trial.stepper();
        trial.calm();
        double until = stepper.time() + Calm.SECONDS;
        try {
            while (stepper.time() < until - 1e-9) {
                trial.step();
            }
        } catch (DivergenceException told) {
            noticed = told.getMessage();
            return;
        }
        drift = Shape.farthest(shape.now(), start);
        within("drift of a node of the rest shape, mm", drift, hard.bounds().driftMm(), stepper.time());
    }

    /** A number that is none is within nothing; where no trusted run is asked for, nothing is asked of what needs it. */
    private void within(String what, double found, double most, double time) {
        if (most < Double.POSITIVE_INFINITY && !(found <= most) && breach.isEmpty()) {
            breach = String.format(
                    Locale.ROOT, "at %.2f s: %s: found %.4g, expected at most %.4g", time, what, found, most);
        }
    }

    private Cell cell(double durationS) {
        String told = noticed.isEmpty() ? split : noticed;
        Verdict verdict =
                !breach.isEmpty() ? Verdict.SILENT_FAILURE : told.isEmpty() ? Verdict.STABLE : Verdict.RECOVERED;
        if (told.isEmpty() && repeat > UNLIKE_MM) {
            told = String.format(
                    Locale.ROOT,
                    "no breath repeats another: nodes end one up to %.2g mm from where they ended another; stopped,"
                            + " all come to rest within %.2g mm of their start",
                    repeat,
                    drift);
        }
        return new Cell(
                hard.key(),
                kind,
                verdict,
                breach.isEmpty() ? told : breach,
                durationS,
                endS,
                trial.stepper().dt(),
                trial.stepper().substeps(),
                trusted == null ? Double.NaN : peak / peakAllowed,
                speed,
                reach,
                trusted == null ? Double.NaN : parted,
                links,
                returned,
                repeat,
                drift);
    }
}
