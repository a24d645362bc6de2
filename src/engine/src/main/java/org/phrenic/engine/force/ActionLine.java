package org.phrenic.engine.force;

import org.phrenic.engine.ForceField;
import org.phrenic.engine.parallel.BlockedNodes;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * The action line of Villard, Bourne and Bello 2009 (after Thalmann): a vertical line through a point with a radius of
 * action. Nodes within the radius are pulled down in contraction (inhale) or pushed up in relaxation (exhale). The
 * force decreases smoothly with the distance from the line. Distances are those of the rest positions, so the profile
 * moves with the tissue.
 */
public final class ActionLine implements ForceField {
    private final BlockedNodes nodes;
    private final double[] distance;
    private final double[] weight;
    private double force;

    /**
     * @param layout layout of the system
     * @param callerNodes the muscle's nodes, caller's numbering
     * @param restPositions of all nodes of the system in the caller's order, mm
     * @param x left-right coordinate of the line, mm (LPS)
     * @param y front-back coordinate of the line, mm (LPS)
     * @param radius radius of action, mm
     */
    public ActionLine(NodeLayout layout, int[] callerNodes, double[] restPositions, double x, double y, double radius) {
        nodes = new BlockedNodes(layout, callerNodes);
        distance = new double[callerNodes.length];
        weight = new double[callerNodes.length];
        for (int i = 0; i < weight.length; i++) {
            double dx = restPositions[3 * callerNodes[i]] - x;
            double dy = restPositions[3 * callerNodes[i] + 1] - y;
            distance[i] = Math.sqrt(dx * dx + dy * dy);
        }
        setRadius(radius);
    }

    /**
     * Sets the radius of action, mm.
     *
     * @throws IllegalArgumentException if it is not more than 0
     */
    public void setRadius(double radius) {
        if (!(radius > 0)) {
            throw new IllegalArgumentException(
                    "radius of an action line: found " + radius + " mm, expected more than 0");
        }
        for (int i = 0; i < weight.length; i++) {
            weight[i] = FallOff.at(distance[i], radius);
        }
    }

    /** Sets the force on a node on the line, mN; positive in contraction (down), negative in relaxation (up). */
    public void setForce(double value) {
        force = value;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] out, int block) {
        for (int i = nodes.start[block]; i < nodes.start[block + 1]; i++) {
            out[nodes.node[i] + 2] -= force * weight[nodes.item[i]];
        }
    }
}
