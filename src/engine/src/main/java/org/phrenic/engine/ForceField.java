package org.phrenic.engine;

/**
 * A force on nodes. Arrays are in internal node order, three numbers a node.
 *
 * <p>Forces are evaluated block by block, possibly on several threads at once. An implementation may read any node,
 * writes only to nodes of the given block, and allocates nothing.
 */
public interface ForceField {

    /**
     * Called once, on one thread, before the forces at a time are evaluated.
     *
     * @param time simulated time, s
     */
    default void prepare(double time) {}

    /**
     * Called instead of {@link #prepare(double)} before the forces on the nodes of blocks {@code from} to {@code end -
     * 1} alone are evaluated, which may be at other times than those on the rest.
     */
    default void prepare(double time, int from, int end) {
        prepare(time);
    }

    /**
     * Adds this field's force on the nodes of one block.
     *
     * @param x positions, mm
     * @param v velocities, mm/s
     * @param force receives the forces, mN
     * @param block number of the block
     */
    void addForces(double[] x, double[] v, double[] force, int block);

    /** Potential energy at these positions, µJ (mN mm); 0 for a field that stores none. */
    default double potentialEnergy(double[] x) {
        return 0;
    }

    /**
     * Adds K u for the nodes of one block, K = -∂force/∂x at x. The default suits forces that do not depend on
     * position. A field may omit terms that would make K indefinite.
     */
    default void addStiffness(double[] x, double[] u, double[] out, int block) {}

    /**
     * Adds for each node a bound of the stiffness row sum |K_ii| + Σ|K_ij| at x (N/m) and of the dashpot row sum (N
     * s/m). These are Gershgorin bounds, from which the largest stable step is estimated.
     */
    default void addRowSums(double[] x, double[] stiffness, double[] damping) {}

    /**
     * Sets the simulated time between two evaluations of prescribed motion. In between, positions are extrapolated at
     * constant velocity. Has no effect on fields without prescribed motion.
     *
     * @param seconds not negative
     */
    default void setRefreshInterval(double seconds) {}

    /** Discards cached values. Call it after positions, parameters or the time were changed from outside. */
    default void invalidate() {}

    /** Saves what this field keeps from earlier times and cannot compute from the state; allocates nothing. */
    default void saveHistory() {}

    /** Restores what {@link #saveHistory} saved last. Called before {@link #invalidate} when a state is restored. */
    default void restoreHistory() {}

    /**
     * Whether this field may act on nodes of blocks {@code from} to {@code end - 1}. Otherwise {@link #prepare} need
     * not be called before the forces of these blocks alone are evaluated.
     */
    default boolean actsOn(int from, int end) {
        return true;
    }

    /** Whether forces depend on velocity, apart from the nodes' own viscous damping. */
    default boolean dependsOnVelocity() {
        return false;
    }
}
