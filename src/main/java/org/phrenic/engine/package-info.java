/**
 * Floor 1: particles, what pulls on them and how they move. A system is a set of nodes in flat arrays, {@linkplain
 * org.phrenic.engine.force force fields}, {@linkplain org.phrenic.engine.constraint constraints} put right after each step, and an
 * {@linkplain org.phrenic.engine.integrator integrator}. No file, no anatomy, no screen.
 *
 * <p>Units: mm, s, kg, mN; so stiffness is N/m (mN/mm), pressure kPa (mN/mm²), energy µJ (mN mm).
 *
 * <p>Work is cut into fixed blocks of neighbouring nodes (see {@link org.phrenic.engine.NodeLayout}); a block's forces are summed in one
 * order by one thread, whichever it is, so results are the same bits for any number of threads.
 */
package org.phrenic.engine;
