package org.phrenic.engine;

/**
 * A condition on node positions, enforced by projection after each step, as a {@link CoupledConstraint whole} or
 * {@link SeparableConstraint item by item}. Velocities are corrected by the same displacement divided by the step h.
 */
public interface Constraint {

    /**
     * Called once before each projection, with nodes where the unconstrained step moved them. May run work in parallel.
     */
    default void prepare(ParticleSystem system, double time) {}

    /**
     * Removes the velocity components that violate the constraint. Called after the last force update of a step, at the
     * current positions (the second half of RATTLE: Andersen 1983, doi 10.1016/0021-9991(83)90014-1). Without it,
     * velocities at whole steps contain h/2 times the constrained acceleration, an error that grows with the step but
     * does not affect positions.
     */
    default void projectVelocities(ParticleSystem system) {}

    /**
     * Whether this is a contact constraint. An implicit scheme solves for the motion under forces alone, so contact
     * adds an error proportional to h.
     */
    default boolean isContact() {
        return false;
    }

    /**
     * Describes what the last projection could not satisfy, as the cause in a sentence; null if the constraint holds.
     */
    default String violation() {
        return null;
    }

    /**
     * Sets the simulated time between two evaluations of prescribed motion. In between, positions are extrapolated at
     * constant velocity. Has no effect on constraints without prescribed motion.
     *
     * @param seconds not negative
     */
    default void setRefreshInterval(double seconds) {}

    /** Discards cached values. Call it after positions, parameters or the time were changed from outside. */
    default void invalidate() {}

    /**
     * Lists the linearised rows of this constraint at the current state, one for each equation or inequality, always in
     * the same order. Cached planes and normals are not updated.
     */
    default void jacobianRows(ParticleSystem system, RowConsumer out) {}

    /** Receives the rows of a constraint. */
    interface RowConsumer {
        /**
         * Adds a row n · (x_a - x_b) = c, or ≥ c.
         *
         * @param a internal number of a node
         * @param b internal number of the other node, or -1 for a wall
         * @param nx x component of the unit direction n
         * @param gap n · (x_a - x_b) - c at the current positions, mm
         * @param oneSided whether the row is the inequality
         */
        void add(int a, int b, double nx, double ny, double nz, double gap, boolean oneSided);
    }

    /** Constraint error at the current positions; the implementation states the measure, relative or absolute. */
    double error(ParticleSystem system);
}
