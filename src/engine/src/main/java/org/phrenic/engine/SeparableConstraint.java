package org.phrenic.engine;

/**
 * A constraint of items that share no node with one another, so that items are projected in any order and in parallel.
 */
public interface SeparableConstraint extends Constraint {

    /**
     * The nodes that items may move, internal numbers times 3: one array for each end of an item, in each one number an
     * item.
     */
    int[][] itemNodes();

    /** Whether no node stands in two items. */
    default boolean isSeparable() {
        return true;
    }

    /**
     * Projects some items; others may be put right at the same time on other threads.
     *
     * @param system the nodes; positions and velocities are changed
     * @param h the step just taken, s
     * @param items their numbers
     * @param from first of them to be put right
     * @param to behind the last
     * @param moved takes, from {@code from} on, the numbers of the items for which a node was moved
     * @return how many these are
     */
    int project(ParticleSystem system, double h, int[] items, int from, int to, int[] moved);
}
