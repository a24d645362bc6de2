package org.phrenic.engine.integrator;

import java.util.function.IntFunction;
import org.phrenic.engine.ParticleSystem;

/**
 * Advances a system in time steps of dt. Each step is split into as many substeps as stability requires. A
 * {@link DivergenceGuard} detects divergence. If a {@link ChatterDetector} finds that the scene has become stiffer than
 * the stability limit predicted, the number of substeps doubles.
 *
 * <p>Time is the step count times dt, not a running sum, to avoid accumulated rounding. After a change of dt it is the
 * sum over the segments of constant dt.
 */
public final class Stepper {
    /**
     * Fraction of the largest stable step that is used. The margin covers stiffness that grows while tissue deforms.
     */
    public static final double SAFETY = 0.9;

    /**
     * Simulated time after {@link #checkpoint} in which no later state replaces it, s. Within it a change shows what it
     * does to tissue: 0.2 s of its ramp, and ten times as much.
     */
    private static final double TRIAL_S = 2;

    /** Largest refinement factor against chatter, relative to the substeps that the limit requires. */
    private static final int MAX_REFINEMENT = 16;

    private Integrator integrator;
    private double dt;
    private final StepPolicy policy;
    private final DivergenceGuard guard;
    private final ChatterDetector watch;
    private StabilityLimit limit;
    private int substeps;
    private int stepsApart = 1;
    /** Refinement factor relative to the substeps that the limit requires. */
    private int refinement = 1;

    private String substepRefinementReason = "";
    private Splitting atCheckpoint;
    /** What was set before the last change; null before the first. */
    private Setup before;

    private long steps;
    /** Start of the segment with the current dt: its first step, and the simulated time there, s. */
    private long segmentStep;

    private double segmentTime;

    /** How steps are split from a step on. */
    private record Splitting(long step, int substeps, int apart, int refinement, String reason) {}

    /** What a change at the step of the splitting may replace. */
    private record Setup(
            Integrator integrator,
            double dt,
            long segmentStep,
            double segmentTime,
            StabilityLimit limit,
            Splitting splitting) {}

    /**
     * @param integrator the scheme, on its system
     * @param dt time step, s, more than 0
     * @param policy what to do beyond the stability limit
     * @throws IllegalArgumentException if dt is not positive and finite, or is beyond the limit; the message states
     *     both numbers
     */
    public Stepper(Integrator integrator, double dt, StepPolicy policy) {
        this(integrator, dt, policy, StabilityLimit.of(integrator.system()));
    }

    /** As the other constructor, with a stability limit that was measured beforehand. */
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
        atCheckpoint = splitting();
    }

    /** Recomputes the stability limit. Call it after stiffness, mass or damping changed. */
    public void measureStabilityLimit() {
        apply(StabilityLimit.of(integrator.system()));
        if (before == null || before.splitting.step != atCheckpoint.step) {
            // No change is taken back with this checkpoint, so the new limit holds there, too.
            atCheckpoint = new Splitting(atCheckpoint.step, substeps, stepsApart, refinement, substepRefinementReason);
        }
    }

    /**
     * Changes scheme and time step. The number of substeps satisfies both limits. The current state becomes the
     * checkpoint, as by {@link #checkpoint}. Earlier changes at the same step leave no trace.
     *
     * @param next the scheme, on the same system
     * @param nextDt time step, s, more than 0
     * @param here limit of the system in its current state
     * @param ahead limit of the system after the change about to be made
     * @throws IllegalArgumentException as the constructor; nothing has changed then
     */
    public void switchTo(Integrator next, double nextDt, StabilityLimit here, StabilityLimit ahead) {
        int most = Math.max(policy.substeps(next.kind(), nextDt, here), policy.substeps(next.kind(), nextDt, ahead));
        double h = nextDt / most;
        int apart = Math.max(policy.stepsApart(next.kind(), h, here), policy.stepsApart(next.kind(), h, ahead));
        takeBackChanges();
        if (nextDt != dt) {
            segmentTime = time();
            segmentStep = steps;
            dt = nextDt;
        }
        integrator = next;
        begin();
        limit = ahead.largestStep(next.kind()) < here.largestStep(next.kind()) ? ahead : here;
        substeps = most;
        stepApart(apart);
        saveCheckpoint();
    }

    /** The scheme before the changes of the current step. */
    public Integrator integratorBeforeChange() {
        return isChanged() ? before.integrator : integrator;
    }

    /** The time step before the changes of the current step, s. */
    public double dtBeforeChange() {
        return isChanged() ? before.dt : dt;
    }

    private boolean isChanged() {
        return before != null && before.splitting.step == steps;
    }

    /** Restores what was set before the changes of the current step; without any, notes what is set. */
    private void takeBackChanges() {
        if (isChanged()) {
            integrator = before.integrator;
            dt = before.dt;
            segmentStep = before.segmentStep;
            segmentTime = before.segmentTime;
            limit = before.limit;
            restore(before.splitting);
        } else {
            before = new Setup(integrator, dt, segmentStep, segmentTime, limit, splitting());
        }
    }

    /**
     * Bounds the displacement of every node from its current position. A step beyond the bound counts as diverged.
     *
     * @param mm more than 0
     */
    public void boundDisplacement(double mm) {
        guard.boundDisplacement(mm);
    }

    /**
     * Confines nodes to a box. A step after which one of them is outside counts as diverged.
     *
     * @param nodes caller's numbers
     * @param lowHigh least x, y, z, then greatest x, y, z, mm; may be infinite
     * @param name of the box, in messages, such as {@code the chest}
     */
    public void confine(int[] nodes, double[] lowHigh, String name) {
        guard.confine(nodes, lowHigh, name);
    }

    /**
     * Names nodes in the messages of a divergence and in {@link #substepRefinementReason}.
     *
     * @param names name of a node by its number in the caller's order; without them, {@code node 12}
     */
    public void nameNodes(IntFunction<String> names) {
        guard.nameNodes(names);
    }

    /**
     * Saves the current state as checkpoint, before a change of neither scheme nor time step. For 2 s of simulated time
     * no later state replaces it, so that a divergence is followed by a state that the change has not deformed. Earlier
     * changes at the same step leave no trace.
     */
    public void checkpoint() {
        takeBackChanges();
        watch.reset();
        saveCheckpoint();
    }

    private void saveCheckpoint() {
        guard.checkpoint(steps, trialSteps());
        keepSplitting();
    }

    private void keepSplitting() {
        atCheckpoint = guard.checkpointStep() == steps ? splitting() : atCheckpoint;
    }

    private Splitting splitting() {
        return new Splitting(steps, substeps, stepsApart, refinement, substepRefinementReason);
    }

    private long trialSteps() {
        return (long) Math.ceil(TRIAL_S / dt);
    }

    private void stepApart(int steps) {
        stepsApart = steps;
        integrator.setStepsApart(steps);
    }

    /** Resets scheme and chatter detection after a change of scheme, step or scene. */
    private void begin() {
        integrator.reset();
        watch.reset();
        refinement = 1;
        substepRefinementReason = "";
    }

    /** Restarts at step 0 from the current state. */
    public void restart(Integrator first, StabilityLimit measured) {
        steps = 0;
        segmentStep = 0;
        segmentTime = 0;
        integrator = first;
        apply(measured);
        atCheckpoint = splitting();
        before = null;
        guard.restart();
    }

    private void apply(StabilityLimit measured) {
        limit = measured;
        substeps = policy.substeps(integrator.kind(), dt, measured);
        stepApart(policy.stepsApart(integrator.kind(), dt / substeps, measured));
        begin();
    }

    /**
     * Advances the system by dt.
     *
     * @throws DivergenceException if the state diverged; the last checkpoint has been restored
     */
    public void step() {
        if (steps == 0) {
            // Changes since construction belong to the initial state.
            guard.checkpoint(0, isChanged() ? trialSteps() : 0);
            keepSplitting();
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
            integrator.system().invalidate();
            // The run goes on as one that never left the checkpoint.
            restore(atCheckpoint);
            integrator.reset();
            watch.reset();
            throw new DivergenceException(segmentTime + (failed - segmentStep) * dt, time(), cause);
        }
        keepSplitting();
    }

    /**
     * Counts a step by dt whose positions and velocities the caller writes into the system, before anything else reads
     * them, instead of having them computed by {@link #step}.
     */
    public void acceptStep() {
        steps++;
        integrator.system().invalidate();
        integrator.reset();
        watch.reset();
    }

    private void restore(Splitting splitting) {
        substeps = splitting.substeps;
        stepApart(splitting.apart);
        refinement = splitting.refinement;
        substepRefinementReason = splitting.reason;
    }

    /** Doubles the number of substeps; returns the cause of chatter if a limit prevents this, else null. */
    private String refine(int node) {
        String cause = guard.nameOfCaller(node) + " turns round in every substep";
        if (policy == StepPolicy.REFUSE || refinement >= MAX_REFINEMENT || 2L * substeps > StepPolicy.MAX_SUBSTEPS) {
            return cause;
        }
        refinement *= 2;
        substeps *= 2;
        substepRefinementReason = cause;
        integrator.reset();
        watch.reset();
        return null;
    }

    /** Why steps are split into more substeps than the limit requires, as a sentence; empty if they are not. */
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

    /** Steps that nodes apart make in a substep of the others; 1 without such nodes. */
    public int stepsApart() {
        return stepsApart;
    }

    /** The last measured stability limit. */
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
