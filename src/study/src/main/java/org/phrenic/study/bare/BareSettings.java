package org.phrenic.study.bare;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * Parameters of the bare workload.
 *
 * @param mass of each node, kg
 * @param stiffness of each spring, N/m
 * @param damping of the dashpot along each spring, N s/m
 * @param load on each loaded node along z, mN
 * @param step time step, s
 * @param integrator scheme
 * @param threads number of worker threads, 1 or more
 * @param steps number of steps in each timed run, 1 or more
 */
public record BareSettings(
        double mass,
        double stiffness,
        double damping,
        double load,
        double step,
        IntegratorKind integrator,
        int threads,
        int steps) {

    /** The parameters used for published figures of other engines: symplectic Euler at 0.01 s, one thread. */
    public static final BareSettings DEFAULT =
            new BareSettings(0.1, 15, 0.02, -0.0005, 0.01, IntegratorKind.SYMPLECTIC_EULER, 1, 1000);

    /** @throws IllegalArgumentException if threads or steps are below 1, or the time step is not positive and finite */
    public BareSettings {
        if (threads < 1) {
            throw new IllegalArgumentException("threads: found " + threads + ", expected 1 or more");
        }
        if (steps < 1) {
            throw new IllegalArgumentException("steps: found " + steps + ", expected 1 or more");
        }
        if (!(step > 0) || Double.isInfinite(step)) {
            throw new IllegalArgumentException("time step: found " + step + " s, expected more than 0");
        }
    }

    public BareSettings withIntegrator(IntegratorKind kind) {
        return new BareSettings(mass, stiffness, damping, load, step, kind, threads, steps);
    }

    public BareSettings withThreads(int count) {
        return new BareSettings(mass, stiffness, damping, load, step, integrator, count, steps);
    }

    public BareSettings withSteps(int count) {
        return new BareSettings(mass, stiffness, damping, load, step, integrator, threads, count);
    }
}
