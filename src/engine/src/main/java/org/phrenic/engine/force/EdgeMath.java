package org.phrenic.engine.force;

import java.util.List;

/**
 * Turns the differences between the ends of a batch of edges into forces on their first ends, with the operations of
 * {@link EdgeLoops} in their order, and so with the same bits. An interface, so that what implements it can be loaded
 * by name, and only where it can run.
 */
interface EdgeMath {
    /**
     * The passes to be made when {@code difference} and, with dashpots, {@code rate} are filled; after them
     * {@code difference} holds forces.
     *
     * @param constants of the springs
     */
    List<EdgeBatch.Pass> passes(SpringData constants);
}
