package org.phrenic.engine;

/**
 * Something that pulls on nodes. Arrays are in internal node order, three numbers a node.
 *
 * <p>Forces are asked for block by block, blocks possibly at the same time on several threads: an implementation reads
 * any node but writes only to nodes of the block it was asked for, and allocates nothing.
 */
public interface ForceField {

    /**
     * Told once, on one thread, before the forces at a time are asked for.
     *
     * @param time simulated time, s
     */
    default void prepare(double time) {}

    /**
     * Adds this field's force on the nodes of one block.
     *
     * @param x positions, mm
     * @param v velocities, mm/s
     * @param force where to add, mN
     * @param block which block's nodes
     */
    void addForces(double[] x, double[] v, double[] force, int block);

    /** Energy stored by this field at these positions, µJ (mN mm); 0 for a field that stores none. */
    default double potentialEnergy(double[] x) {
        return 0;
    }

    /**
     * Adds K u for the nodes of one block, K = -∂force/∂x at x; the default is a field whose force does not depend on
     * position. A field may leave out what would make K indefinite.
     */
    default void addStiffness(double[] x, double[] u, double[] out, int block) {}

    /**
     * Adds to each node a bound of its row sum |K_ii| + Σ|K_ij| (N/m) and of the like sum of its dashpots (N s/m):
     * Gershgorin's bound, from which the largest stable step is estimated.
     */
    default void addRowSums(double[] stiffness, double[] damping) {}

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

    /** Whether forces depend on velocity other than through the nodes' own viscous damping. */
    default boolean dependsOnVelocity() {
        return false;
    }
}
