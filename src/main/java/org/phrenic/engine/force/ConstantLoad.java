package org.phrenic.engine.force;

import org.phrenic.engine.ForceField;
import org.phrenic.engine.NodeLayout;

/** A dead load: one constant force a node, times a factor that may change (gravity, a weight, what holds a scan's shape). */
public final class ConstantLoad implements ForceField {
    private final NodeLayout layout;
    private final double[] load;
    private double factor = 1;

    /**
     * @param layout of the system it is for
     * @param load three numbers a node in the caller's order, mN
     */
    public ConstantLoad(NodeLayout layout, double[] load) {
        if (load.length != 3 * layout.nodeCount()) {
            throw new IllegalArgumentException(
                    "load: found " + load.length + " numbers, expected " + 3 * layout.nodeCount());
        }
        this.layout = layout;
        this.load = layout.toInternal(load);
    }

    /** Multiplies the whole load from now on. */
    public void setFactor(double value) {
        factor = value;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        int end = 3 * layout.end(block);
        for (int i = 3 * layout.start(block); i < end; i++) {
            force[i] += factor * load[i];
        }
    }

    /** Minus the work of the load from the origin. */
    @Override
    public double potentialEnergy(double[] x) {
        double sum = 0;
        for (int i = 0; i < load.length; i++) {
            sum -= factor * load[i] * x[i];
        }
        return sum;
    }
}
