package org.phrenic.model.organ;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;

/**
 * Points that move with nodes: each keeps its rest offset from its node and has the node's velocity. The paper's lungs
 * are attached to the diaphragm in this way. The points exert no force on the nodes, so the soft lung cannot make the
 * sheet snap from one fold into another, which springs between the two caused.
 */
public final class NodeFollowers implements PrescribedMotion {
    private final ParticleSystem system;
    /** Node of each point, as an offset into positions. */
    private final int[] node;

    private final double[] offset;

    /**
     * @param nodes node of each point, caller's numbering
     * @param points positions at rest, three numbers each, mm
     */
    public NodeFollowers(ParticleSystem system, int[] nodes, double[] points) {
        this.system = system;
        node = new int[nodes.length];
        offset = points.clone();
        double[] x = system.positions();
        for (int i = 0; i < nodes.length; i++) {
            node[i] = 3 * system.layout().internal(nodes[i]);
            for (int axis = 0; axis < 3; axis++) {
                offset[3 * i + axis] -= x[node[i] + axis];
            }
        }
    }

    @Override
    public int pointCount() {
        return node.length;
    }

    @Override
    public void at(double time, double[] position, double[] velocity) {
        double[] x = system.positions();
        double[] v = system.velocities();
        for (int i = 0; i < node.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                position[3 * i + axis] = x[node[i] + axis] + offset[3 * i + axis];
                velocity[3 * i + axis] = v[node[i] + axis];
            }
        }
    }
}
