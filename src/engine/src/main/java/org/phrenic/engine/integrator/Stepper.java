package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;

/**
 * The clock of a system: whole steps of dt, each split into as many substeps as stability asks for, watched by a
 * {@link DivergenceGuard} and a {@link ChatterDetector}: a scene that has become stiffer than the limit foresaw is
 * carried on in twice as many parts. Time is the step count times dt, never a sum; where dt is changed, the sum over
 * the stretches of one dt, each a count times its dt.
 */
public final class Stepper {
    /** Share of the largest stable step that is used: room for stiffness that grows while tissue deforms. */
    public static final double SAFETY = 0.9;

    /** Into at most so many parts is a step split: more would look as if the program had stopped. */
    public static final int MAX_SUBSTEPS = 10_000;

    /** So many times as many parts as the limit asks for are tried against chatter. */
    private static final int MAX_REFINEMENT = 16;

    private Integrator integrator;
    private double dt;
    private final StepPolicy policy;
    private final DivergenceGuard guard;
    private final ChatterDetector watch;
    private StabilityLimit limit;
    private int substeps;
    /** How many times as many parts as the limit asks for. */
    private int refinement = 1;

    private String substepRefinementReason = "";
    private long steps;
    /** Where the present time step began to count: its step, and the time that the steps before it add up to. */
    private long segmentStep;

    private double segmentTime;

    /**
     * @param integrator the scheme, on its system
     * @param dt time step, s, more than 0
     * @param policy what to do beyond the stability limit
     * @throws IllegalArgumentException if dt is not positive and finite, or is refused; the sentence states both
     *     numbers
     */
    public Stepper(Integrator integrator, double dt, StepPolicy policy) {
        this(integrator, dt, policy, StabilityLimit.of(integrator.system()));
    }

    /** The same for a system whose stability limit was measured a moment ago; parameters as for the other. */
    public Stepper(Integrator integrator, double dt, StepPolicy policy, StabilityLimit measured) {
        if (!(dt > 0) || Double.isInfinite(dt)) {
            throw new IllegalArgumentException("time step: found " + dt + " s, expected more than 0");
        }
        this.integrator = integrator;
        this.dt = dt;
        this.policy = policy;
        this.guard = new DivergenceGuard(integrator.system());
        this.watch = new ChatterDetector(integrator.system());
        apply(measured);
    }

    /** Estimates the stability limit anew: to be called after stiffness, mass or damping changed. */
    public void measureStabilityLimit() {
        apply(StabilityLimit.of(integrator.system()));
    }

    /**
     * Goes on with another scheme and time step, and so many substeps as the worse of two limits asks for; the state at
     * hand is kept as one to go back to.
     *
     * @param next the scheme, on the same system
     * @param nextDt time step, s, more than 0
     * @param here limit of the system as it is
     * @param ahead limit of the system as it is about to be
     * @throws IllegalArgumentException as the constructor; nothing has changed then
     */
    public void switchTo(Integrator next, double nextDt, StabilityLimit here, StabilityLimit ahead) {
        int most = Math.max(split(next.kind(), nextDt, here), split(next.kind(), nextDt, ahead));
        guard.checkpoint(steps);
        if (nextDt != dt) {
            segmentTime = time();
            segmentStep = steps;
            dt = nextDt;
        }
        integrator = next;
        begin();
        limit = ahead.largestStep(next.kind()) < here.largestStep(next.kind()) ? ahead : here;
        substeps = most;
    }

    /**
     * From now on no node may go farther from where it is: beyond, a step is given back as one that diverged.
     *
     * @param mm more than 0
     */
    public void boundDisplacement(double mm) {
        guard.boundDisplacement(mm);
    }

    /** Keeps the state at hand as one to go back to. */
    public void checkpoint() {
        guard.checkpoint(steps);
    }

    /** Into how many substeps a step is split under a limit, or refused. */
    private int split(IntegratorKind kind, double step, StabilityLimit measured) {
        if (policy == StepPolicy.REFUSE && !measured.isStable(kind, step)) {
            throw new IllegalArgumentException(measured.describe(kind, step) + ": refused");
        }
        int parts = policy == StepPolicy.REFUSE ? 1 : measured.substeps(kind, step, SAFETY);
        if (parts > MAX_SUBSTEPS) {
            throw new IllegalArgumentException(measured.describe(kind, step) + ": it would take " + parts
                    + " substeps, expected at most " + MAX_SUBSTEPS
                    + " (choose verlet or backward-euler, or a shorter time step)");
        }
        return parts;
    }

    /** After a change of scheme, step or scene: nothing is known of chatter yet. */
    private void begin() {
        integrator.reset();
        watch.reset();
        refinement = 1;
        substepRefinementReason = "";
    }

    /** Back to step 0, the system being where it starts. */
    public void restart(Integrator first, StabilityLimit measured) {
        steps = 0;
        segmentStep = 0;
        segmentTime = 0;
        integrator = first;
        apply(measured);
        guard.restart();
    }

    private void apply(StabilityLimit measured) {
        limit = measured;
        substeps = split(integrator.kind(), dt, measured);
        begin();
    }

    /**
     * Carries the system over one dt.
     *
     * @throws DivergenceException if the state left all bounds; the last good state has been restored
     */
    public void step() {
        if (steps == 0) {
            // What was set since this was made belongs to the start.
            guard.checkpoint(0);
        }
        double h = dt / substeps;
        int chattering = -1;
        for (int i = 0; i < substeps; i++) {
            integrator.step(segmentTime + ((steps - segmentStep) * (long) substeps + i) * h, h);
            int node = watch.afterSubstep(integrator.kind());
            chattering = node < 0 ? chattering : node;
        }
        steps++;
        String cause = guard.check(steps);
        if (cause == null && chattering >= 0) {
            cause = refine(chattering);
        }
        if (cause != null) {
            long failed = steps;
            steps = guard.restore();
            integrator.reset();
            watch.reset();
            throw new DivergenceException(segmentTime + (failed - segmentStep) * dt, time(), cause);
        }
    }

    /** Splits steps into twice as many parts from now on; the cause if that may not be or has not helped. */
    private String refine(int node) {
        String cause = "node " + node + " turns round in every substep";
        if (policy == StepPolicy.REFUSE || refinement >= MAX_REFINEMENT || 2L * substeps > MAX_SUBSTEPS) {
            return cause;
        }
        refinement *= 2;
        substeps *= 2;
        substepRefinementReason = cause;
        integrator.reset();
        watch.reset();
        return null;
    }

    /**
     * Why steps are split into more parts than the limit asks for, as the cause in a sentence; empty if they are not.
     */
    public String substepRefinementReason() {
        return substepRefinementReason;
    }

    /** Simulated time, s. */
    public double time() {
        return segmentTime + (steps - segmentStep) * dt;
    }

    public long steps() {
        return steps;
    }

    public double dt() {
        return dt;
    }

    /** Substeps a step. */
    public int substeps() {
        return substeps;
    }

    /** The limit as last measured. */
    public StabilityLimit limit() {
        return limit;
    }

    public Integrator integrator() {
        return integrator;
    }

    public ParticleSystem system() {
        return integrator.system();
    }
}
