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

    /**
     * Sets the number of equal steps in which the {@link org.phrenic.engine.parallel.NodeLayout#hasNodesApart nodes
     * apart} make each step of the others. Only schemes of a kind that {@link IntegratorKind#stepsNodesApart steps
     * nodes apart} take more than one.
     */
    default void setStepsApart(int steps) {
        if (steps != 1) {
            throw new IllegalArgumentException(kind().label() + ": found " + steps + " steps apart, expected 1");
        }
    }

    /** The system that is integrated. */
    ParticleSystem system();
}
