package org.phrenic.engine.force;

import java.util.stream.IntStream;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.parallel.BlockedNodes;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * A dead load: one constant force a node, times a variable load factor (gravity, a weight, the preload that keeps a
 * scan's shape).
 */
public final class ConstantLoad implements ForceField {
    private final BlockedNodes nodes;
    /** Three components for each entry of {@link #nodes}. */
    private final double[] load;

    private double loadFactor = 1;

    /**
     * @param layout layout of the system
     * @param load three components a node in the caller's order, mN
     */
    public ConstantLoad(NodeLayout layout, double[] load) {
        if (load.length != 3 * layout.nodeCount()) {
            throw new IllegalArgumentException(
                    "load: found " + load.length + " numbers, expected " + 3 * layout.nodeCount());
        }
        int[] loaded = IntStream.range(0, layout.nodeCount())
                .filter(i -> load[3 * i] != 0 || load[3 * i + 1] != 0 || load[3 * i + 2] != 0)
                .toArray();
        nodes = new BlockedNodes(layout, loaded);
        this.load = new double[3 * loaded.length];
        for (int i = 0; i < loaded.length; i++) {
            System.arraycopy(load, 3 * loaded[nodes.item[i]], this.load, 3 * i, 3);
        }
    }

    /** Sets the factor on the whole load. */
    public void setLoadFactor(double value) {
        loadFactor = value;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        int[] node = nodes.node;
        double[] f = load;
        double s = loadFactor;
        if (s == 0) {
            return;
        }
        int end = nodes.start[block + 1];
        for (int i = nodes.start[block]; i < end; i++) {
            int n = node[i];
            force[n] += s * f[3 * i];
            force[n + 1] += s * f[3 * i + 1];
            force[n + 2] += s * f[3 * i + 2];
        }
    }

    /** The negative work of the load from the origin, µJ. */
    @Override
    public double potentialEnergy(double[] x) {
        double sum = 0;
        for (int i = 0; i < load.length; i++) {
            sum -= loadFactor * load[i] * x[nodes.node[i / 3] + i % 3];
        }
        return sum;
    }
}
