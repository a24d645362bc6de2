package org.phrenic.engine.force;

import java.util.List;

/**
 * Turns the differences between the ends of a batch of edges into forces on their first ends: with d = x(b) - x(a), u = v(b) - v(a) and L = l0 - a s,
 *
 * <pre>
 * q = 1 / |d|,   t = k (1 - L q) + c (u·d) (q q),   f = t d
 * </pre>
 *
 * <p>Every implementation does these operations in this order and rounds after each, so that all give the same bits.
 */
interface EdgeMath {
    /**
     * The passes to be made when {@code difference} and, with dashpots, {@code rate} are filled; after them {@code difference} holds forces.
     *
     * @param constants of the springs
     */
    List<EdgeBatch.Pass> passes(EdgeConstants constants);
}
