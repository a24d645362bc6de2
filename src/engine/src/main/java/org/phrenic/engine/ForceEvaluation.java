package org.phrenic.engine;

import java.util.Arrays;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * The force on each node as a function of time, without the nodes' own viscous damping. Arrays are bound once, so that
 * an evaluation allocates nothing. Created by {@link ParticleSystem#evaluation}.
 */
public final class ForceEvaluation {
    /** Number of nodes from which state and springs exceed a core's own cache, so that each block is prefetched. */
    private static final int PREFETCH_FROM_NODES = 1 << 15;

    /** Doubles in a cache line. */
    private static final int CACHE_LINE = 8;

    private final ForceSet fields;
    private final NodeLayout layout;
    private final Workers workers;
    private final double[] position;
    private final double[] velocity;
    private final double[] force;
    private final Workers.Task after;
    /** Null without selective mass. */
    private final SelectiveMass selectiveMass;
    /** One value a block, which keeps the compiler from removing the prefetching reads; empty without prefetching. */
    private final double[] prefetched;

    private final Workers.Task task = this::block;
    private int firstBlock;
    private final Workers.Task taskOfRange = piece -> block(firstBlock + piece);

    ForceEvaluation(
            ParticleSystem system,
            ForceSet fields,
            double[] position,
            double[] velocity,
            double[] force,
            Workers.Task after,
            SelectiveMass selectiveMass) {
        this.selectiveMass = selectiveMass;
        this.fields = fields;
        this.layout = system.layout();
        this.workers = system.workers();
        this.position = position;
        this.velocity = velocity;
        this.force = force;
        this.after = after;
        prefetched = new double[layout.nodeCount() < PREFETCH_FROM_NODES ? 0 : layout.blockCount()];
    }

    /**
     * Computes the forces at the current positions and velocities.
     *
     * @param time simulated time, s; prescribed nodes must already be at their positions for this time
     */
    public void at(double time) {
        fields.prepare(time);
        workers.run(layout.blockCount(), task);
        if (selectiveMass != null) {
            selectiveMass.scaleForces(force);
            if (after != null) {
                workers.run(layout.blockCount(), after);
            }
        }
    }

    /**
     * Computes the forces on the nodes of blocks {@code from} to {@code end - 1} alone.
     *
     * @param time simulated time, s; prescribed nodes among them must already be at their positions for this time
     */
    public void at(double time, int from, int end) {
        fields.prepare(time, from, end);
        firstBlock = from;
        workers.run(end - from, taskOfRange);
        if (selectiveMass != null && from == 0) {
            selectiveMass.scaleForces(force);
        }
    }

    private void block(int block) {
        int from = 3 * layout.start(block);
        int end = 3 * layout.end(block);
        if (prefetched.length > 0) {
            prefetched[block] = prefetch(position, from, end) + prefetch(velocity, from, end);
        }
        Arrays.fill(force, from, end, 0);
        fields.addForces(position, velocity, force, block);
        if (after != null && selectiveMass == null) {
            after.run(block);
        }
    }

    /** Reads one value of each cache line. The reads are independent, so memory serves many of them at once. */
    private static double prefetch(double[] values, int from, int end) {
        double sum = 0;
        for (int i = from; i < end; i += CACHE_LINE) {
            sum += values[i];
        }
        return sum;
    }
}
