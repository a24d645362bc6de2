package org.phrenic.engine.force;

import org.phrenic.engine.ForceField;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.parallel.BlockedNodes;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Springs of zero rest length from nodes to moving anchors: F = -k (x - anchor(t)) - c (v - anchor velocity). This is
 * the attachment by a mass-spring system of low elasticity of Villard, Bourne and Bello 2009. The stiffness of each
 * node contains the fall-off that keeps the deformation smooth ({@link FallOff}).
 */
public final class Attachments implements ForceField {
    private final BlockedNodes nodes;
    private final int[] callerNodes;
    /**
     * Stiffness for each entry of {@link #nodes}, so that a block reads consecutive values; anchors likewise, three
     * each.
     */
    private final double[] stiffness;

    private final double dampingRatio;
    private final PrescribedMotion anchors;
    private final double[] anchor;
    private final double[] anchorVelocity;
    /** Anchors in the caller's order; the same arrays as the anchors of entries where the orders agree. */
    private final double[] given;

    private final double[] givenVelocity;
    private double refreshInterval;
    private double refreshed = Double.NaN;
    private double elapsed;
    private double stiffnessFactor = 1;
    /** Constant force for each entry, three components; null for none. */
    private double[] preload;

    /**
     * @param layout layout of the system
     * @param callerNodes the attached nodes, caller's numbering
     * @param stiffness stiffness of each spring, N/m
     * @param damping ratio of dashpot coefficient to stiffness, s; 0 for none
     * @param anchors anchor of each node, in the same order
     * @throws IllegalArgumentException if counts differ, or a stiffness or the damping is negative or not finite
     */
    public Attachments(
            NodeLayout layout, int[] callerNodes, double[] stiffness, double damping, PrescribedMotion anchors) {
        if (stiffness.length != callerNodes.length || anchors.pointCount() != callerNodes.length) {
            throw new IllegalArgumentException("attachments: found " + callerNodes.length + " nodes, "
                    + stiffness.length + " stiffnesses and " + anchors.pointCount() + " anchors, expected as many");
        }
        for (int i = 0; i < stiffness.length; i++) {
            if (!(stiffness[i] >= 0) || Double.isInfinite(stiffness[i])) {
                throw new IllegalArgumentException(
                        "stiffness of attachment " + i + ": found " + stiffness[i] + " N/m, expected 0 or more");
            }
        }
        if (!(damping >= 0) || Double.isInfinite(damping)) {
            throw new IllegalArgumentException("damping of attachments: found " + damping + " s, expected 0 or more");
        }
        this.callerNodes = callerNodes.clone();
        this.nodes = new BlockedNodes(layout, callerNodes);
        this.stiffness = new double[stiffness.length];
        this.dampingRatio = damping;
        this.anchors = anchors;
        this.anchor = new double[3 * callerNodes.length];
        this.anchorVelocity = new double[3 * callerNodes.length];
        this.given = nodes.isSorted() ? anchor : new double[3 * callerNodes.length];
        this.givenVelocity = nodes.isSorted() ? anchorVelocity : new double[3 * callerNodes.length];
        copyStiffness(stiffness);
        refreshAnchors(0);
    }

    private void copyStiffness(double[] each) {
        for (int i = 0; i < stiffness.length; i++) {
            stiffness[i] = each[nodes.item[i]];
        }
    }

    private void refreshAnchors(double time) {
        anchors.at(time, given, givenVelocity);
        if (!nodes.isSorted()) {
            nodes.toEntries(given, anchor);
            nodes.toEntries(givenVelocity, anchorVelocity);
        }
    }

    /**
     * Sets the simulated time between two evaluations of the anchors. In between, they are extrapolated at constant
     * velocity. 0, the default, evaluates them every time.
     *
     * @param seconds not negative
     */
    @Override
    public void setRefreshInterval(double seconds) {
        refreshInterval = seconds;
    }

    /**
     * Replaces the coefficients of every spring during a simulation. Allocates only on the first call.
     *
     * @param k stiffness of each spring, N/m
     * @param constant additional constant force on each node, three components, mN
     */
    public void setCoefficients(double[] k, double[] constant) {
        if (preload == null) {
            preload = new double[constant.length];
        }
        copyStiffness(k);
        nodes.toEntries(constant, preload);
    }

    /** Stiffness of each spring, without the stiffness factor, N/m; a copy. */
    public double[] stiffnesses() {
        double[] each = new double[stiffness.length];
        for (int i = 0; i < each.length; i++) {
            each[nodes.item[i]] = stiffness[i];
        }
        return each;
    }

    /** The attached nodes in the caller's numbering, in the order given; a copy. */
    public int[] callerNodes() {
        return callerNodes.clone();
    }

    /** Factor on every stiffness. */
    public double stiffnessFactor() {
        return stiffnessFactor;
    }

    /** Anchor positions at a time, mm. */
    public double[] anchorsAt(double time) {
        double[] at = new double[anchor.length];
        anchors.at(time, at, new double[anchor.length]);
        return at;
    }

    @Override
    public void invalidate() {
        refreshed = Double.NaN;
    }

    @Override
    public void saveHistory() {
        anchors.saveMotion();
    }

    @Override
    public void restoreHistory() {
        anchors.restoreMotion();
    }

    /** Sets a factor on every stiffness. */
    public void setStiffnessFactor(double value) {
        stiffnessFactor = value;
    }

    @Override
    public void prepare(double time) {
        if (anchors.isStationary()) {
            return;
        }
        // The tolerance prevents rounding of the time from delaying a refresh by a step. Going back in time refreshes
        // too.
        if (!(Math.abs(time - refreshed) < refreshInterval * (1 - 1e-9))) {
            refreshAnchors(time);
            refreshed = time;
        }
        elapsed = time - refreshed;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        int end = nodes.start[block + 1];
        for (int from = nodes.start[block]; from < end; from += NodeLayout.LOOP_CHUNK) {
            addForces(x, v, force, from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
    }

    private void addForces(double[] x, double[] v, double[] force, int from, int end) {
        if (anchors.isStationary() && dampingRatio == 0) {
            pull(x, force, from, end);
        } else if (dampingRatio == 0) {
            pullAfter(x, force, from, end);
        } else {
            pullAlong(x, v, force, from, end);
        }
        if (preload != null) {
            int[] node = nodes.node;
            double[] constant = preload;
            for (int i = from; i < end; i++) {
                force[node[i]] += constant[3 * i];
                force[node[i] + 1] += constant[3 * i + 1];
                force[node[i] + 2] += constant[3 * i + 2];
            }
        }
    }

    /** Forces of stationary anchors without dashpots. */
    private void pull(double[] x, double[] force, int from, int end) {
        int[] node = nodes.node;
        double[] each = stiffness;
        double[] to = anchor;
        double all = stiffnessFactor;
        for (int i = from; i < end; i++) {
            int n = node[i];
            double k = all * each[i];
            force[n] += k * (to[3 * i] - x[n]);
            force[n + 1] += k * (to[3 * i + 1] - x[n + 1]);
            force[n + 2] += k * (to[3 * i + 2] - x[n + 2]);
        }
    }

    /** Forces of moving anchors without dashpots. */
    private void pullAfter(double[] x, double[] force, int from, int end) {
        int[] node = nodes.node;
        double[] each = stiffness;
        double[] to = anchor;
        double[] speed = anchorVelocity;
        double all = stiffnessFactor;
        double since = elapsed;
        for (int i = from; i < end; i++) {
            int n = node[i];
            int p = 3 * i;
            double k = all * each[i];
            force[n] += k * (to[p] + since * speed[p] - x[n]);
            force[n + 1] += k * (to[p + 1] + since * speed[p + 1] - x[n + 1]);
            force[n + 2] += k * (to[p + 2] + since * speed[p + 2] - x[n + 2]);
        }
    }

    /** Forces of moving anchors with dashpots. */
    private void pullAlong(double[] x, double[] v, double[] force, int from, int end) {
        int[] node = nodes.node;
        double[] each = stiffness;
        double[] to = anchor;
        double[] speed = anchorVelocity;
        double all = stiffnessFactor;
        double ratio = dampingRatio;
        double since = elapsed;
        for (int i = from; i < end; i++) {
            int n = node[i];
            int p = 3 * i;
            double k = all * each[i];
            double c = k * ratio;
            force[n] += k * (to[p] + since * speed[p] - x[n]) + c * (speed[p] - v[n]);
            force[n + 1] += k * (to[p + 1] + since * speed[p + 1] - x[n + 1]) + c * (speed[p + 1] - v[n + 1]);
            force[n + 2] += k * (to[p + 2] + since * speed[p + 2] - x[n + 2]) + c * (speed[p + 2] - v[n + 2]);
        }
    }

    @Override
    public double potentialEnergy(double[] x) {
        double sum = 0;
        for (int i = 0; i < nodes.count(); i++) {
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = x[nodes.node[i] + axis] - anchor[3 * i + axis] - elapsed * anchorVelocity[3 * i + axis];
                squared += d * d;
            }
            sum += 0.5 * stiffnessFactor * stiffness[i] * squared;
            for (int axis = 0; preload != null && axis < 3; axis++) {
                sum -= preload[3 * i + axis] * x[nodes.node[i] + axis];
            }
        }
        return sum;
    }

    @Override
    public void addStiffness(double[] x, double[] u, double[] out, int block) {
        for (int i = nodes.start[block]; i < nodes.start[block + 1]; i++) {
            int n = nodes.node[i];
            double k = stiffnessFactor * stiffness[i];
            for (int axis = 0; axis < 3; axis++) {
                out[n + axis] += k * u[n + axis];
            }
        }
    }

    @Override
    public void addRowSums(double[] x, double[] stiffnessSum, double[] dampingSum) {
        for (int i = 0; i < nodes.count(); i++) {
            double k = stiffnessFactor * stiffness[i];
            stiffnessSum[nodes.node[i] / 3] += k;
            dampingSum[nodes.node[i] / 3] += dampingRatio * k;
        }
    }

    @Override
    public boolean actsOn(int from, int end) {
        return nodes.start[from] < nodes.start[end];
    }

    @Override
    public boolean dependsOnVelocity() {
        return dampingRatio != 0;
    }
}
