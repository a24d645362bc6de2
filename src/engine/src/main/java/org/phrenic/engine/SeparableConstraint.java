package org.phrenic.engine;

/** A constraint of independent items: no two share a node, so items are projected in any order and in parallel. */
public interface SeparableConstraint extends Constraint {

    /**
     * The nodes that items may move, as internal numbers times 3: one array for each end of an item, with one entry an
     * item.
     */
    int[][] itemNodes();

    /** Whether no node belongs to two items. */
    default boolean isSeparable() {
        return true;
    }

    /**
     * Projects some items; other items may be projected on other threads at the same time.
     *
     * @param system the particle system; positions and velocities are changed
     * @param h the step just taken, s
     * @param items item numbers
     * @param from first index in {@code items}
     * @param to index after the last
     * @param moved receives, from index {@code from}, the numbers of the items that moved a node
     * @return number of items that moved a node
     */
    int project(ParticleSystem system, double h, int[] items, int from, int to, int[] moved);
}
