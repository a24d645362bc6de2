package org.phrenic.engine;

/**
 * A condition on positions, enforced by projection after each step, as a {@link CoupledConstraint whole} or
 * {@link SeparableConstraint item by item}; velocities get the same shift over h.
 */
public interface Constraint {

    /**
     * Told once before the constraint is projected at a time, with nodes where the step without constraints has left
     * them; it may share out work.
     */
    default void prepare(ParticleSystem system, double time) {}

    /**
     * Takes away what velocities have against the constraint after a step's last forces were added to them, at the
     * positions at hand (the second half of RATTLE: Andersen 1983, doi 10.1016/0021-9991(83)90014-1). Without it
     * velocities at whole steps carry h/2 of what the constraint holds back, which grows with the step and moves
     * nothing.
     */
    default void projectVelocities(ParticleSystem system) {}

    /**
     * Whether nodes lean on it: an implicit scheme, which solves for where forces alone would carry nodes, then goes
     * wrong by h times as much.
     */
    default boolean isContact() {
        return false;
    }

    /** What could not be made to hold in the last projection, as the cause in a sentence; null where all holds. */
    default String violation() {
        return null;
    }

    /**
     * Sets how much simulated time may go by before what moves by a given motion is asked for anew; in between it goes
     * on at its velocity. Nothing where nothing is kept.
     *
     * @param seconds not negative
     */
    default void setRefreshInterval(double seconds) {}

    /**
     * Forgets what was kept from earlier times: to be called after positions, parameters or the time were changed from
     * outside.
     */
    default void invalidate() {}

    /**
     * Names what this constraint asks of nodes at the state at hand, one equation or inequality after the other, always
     * in the same order; what it kept from its last projection (planes, normals) stays as it is.
     */
    default void jacobianRows(ParticleSystem system, RowConsumer out) {}

    /** Takes the rows of a constraint. */
    interface RowConsumer {
        /**
         * A row n · (x_a - x_b) = c, or ≥ c.
         *
         * @param a internal number of a node
         * @param b internal number of the other, or -1 for a wall
         * @param nx direction, of length 1
         * @param gap n · (x_a - x_b) - c now, mm
         * @param oneSided whether more than c is free
         */
        void add(int a, int b, double nx, double ny, double nz, double gap, boolean oneSided);
    }

    /** How far from holding at these positions, as a relative or absolute measure that the implementation states. */
    double error(ParticleSystem system);
}
