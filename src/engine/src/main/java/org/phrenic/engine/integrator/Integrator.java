package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;

/**
 * A scheme that carries a {@link ParticleSystem} over one time step. It owns its work arrays: one integrator, one
 * system.
 */
public interface Integrator {

    /** What this scheme is. */
    IntegratorKind kind();

    /**
     * Carries the system from time to time + h, constraints included. Allocates nothing.
     *
     * @param time simulated time at the start, s
     * @param h step, s, more than 0
     */
    void step(double time, double h);

    /**
     * Forgets what was kept from earlier steps: to be called after positions, velocities or forces were changed from
     * outside.
     */
    void reset();

    /** The system that is carried. */
    ParticleSystem system();
}
