package org.phrenic.engine;

/** A constraint that is projected as a whole because its parts share nodes. */
public interface CoupledConstraint extends Constraint {

    /**
     * Moves nodes so that the constraint holds.
     *
     * @param system the particle system; positions and velocities are changed
     * @param h the step just taken, s
     */
    void project(ParticleSystem system, double h);
}
