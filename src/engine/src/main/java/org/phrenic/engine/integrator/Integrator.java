package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;

/**
 * A scheme that advances a {@link ParticleSystem} by one time step. It owns its work arrays, so each system needs its
 * own integrator.
 */
public interface Integrator {

    /** The kind of this scheme. */
    IntegratorKind kind();

    /**
     * Advances the system from time to time + h, including constraints. Allocates nothing.
     *
     * @param time simulated time at the start, s
     * @param h step, s, more than 0
     */
    void step(double time, double h);

    /**
     * Discards cached values of earlier steps. Call it after positions, velocities or forces were changed from outside.
     */
    void reset();

    /** The system that is integrated. */
    ParticleSystem system();
}
