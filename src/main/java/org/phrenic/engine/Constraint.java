package org.phrenic.engine;

/** Something that positions must obey, put right after each step; velocities are corrected by the same shift over h. */
public interface Constraint {

    /** Told once, on one thread, before the constraint is put right at a time. */
    default void prepare(double time) {}

    /**
     * Moves nodes so that the constraint holds.
     *
     * @param system the nodes; positions and velocities are changed
     * @param h the step just taken, s
     */
    void project(ParticleSystem system, double h);

    /** Forgets what was kept from earlier times: to be called after positions, parameters or the time were changed from outside. */
    default void forget() {}

    /** How far from holding at these positions, as a relative or absolute measure that the implementation states. */
    double error(ParticleSystem system);
}
