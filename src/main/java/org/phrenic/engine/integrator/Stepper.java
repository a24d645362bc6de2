package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;

/**
 * The clock of a system: whole steps of dt, each split into as many substeps as stability asks for, each watched by a {@link
 * DivergenceGuard}. Time is the step count times dt, never a sum.
 */
public final class Stepper {
    /** Share of the largest stable step that is used: room for stiffness that grows while tissue deforms. */
    public static final double SAFETY = 0.9;

    private final Integrator integrator;
    private final double dt;
    private final StepPolicy policy;
    private final DivergenceGuard guard;
    private StabilityLimit limit;
    private int substeps;
    private long steps;

    /**
     * @param integrator the scheme, on its system
     * @param dt time step, s, more than 0
     * @param policy what to do beyond the stability limit
     * @throws IllegalArgumentException if dt is not positive and finite, or is refused; the sentence states both numbers
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
        apply(measured);
    }

    /** Estimates the stability limit anew: to be called after stiffness, mass or damping changed. */
    public void measure() {
        apply(StabilityLimit.of(integrator.system()));
    }

    private void apply(StabilityLimit measured) {
        limit = measured;
        if (policy == StepPolicy.REFUSE && !limit.isStable(integrator.kind(), dt)) {
            throw new IllegalArgumentException(limit.sentence(integrator.kind(), dt) + ": refused");
        }
        substeps = policy == StepPolicy.REFUSE ? 1 : limit.substeps(integrator.kind(), dt, SAFETY);
        integrator.reset();
    }

    /**
     * Carries the system over one dt.
     *
     * @throws DivergenceException if the state left all bounds; the last good state has been restored
     */
    public void step() {
        if (steps == 0) {
            // What was set since this was made belongs to the start.
            guard.keep(0);
        }
        double h = dt / substeps;
        for (int i = 0; i < substeps; i++) {
            integrator.step((steps * (long) substeps + i) * h, h);
        }
        steps++;
        String cause = guard.check(steps);
        if (cause != null) {
            long failed = steps;
            steps = guard.restore();
            integrator.reset();
            throw new DivergenceException(failed * dt, time(), cause);
        }
    }

    /** Simulated time, s. */
    public double time() {
        return steps * dt;
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
