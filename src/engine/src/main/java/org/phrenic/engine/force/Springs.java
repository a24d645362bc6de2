package org.phrenic.engine.force;

import java.util.Arrays;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.math.DenseVectors;
import org.phrenic.engine.parallel.BlockedEdges;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Linear springs, F = -k (l - l0) along the edge (Villard, Bourne and Bello 2009, eq. 3), optionally with a dashpot, F
 * = -c l̇. Optionally contractile: the rest length becomes l0 (1 - a s), where a is the activation of the whole field
 * and s the contractile share of an edge: 1 for an edge that shortens by a, 0 for passive tissue, negative for one that
 * lengthens.
 */
public final class Springs implements ForceField {
    /** Incompressible tissue widens by at most half of what it shortens. */
    private static final double LEAST_SHARE = -0.5;

    private final BlockedEdges edges;
    private final double[] stiffness;
    private final double[] rest;
    private final double[] share;
    private final SpringData constants;
    private final SpringKernel kernel;

    private Springs(Builder b) {
        edges = new BlockedEdges(b.layout, b.nodeA, b.nodeB);
        stiffness = b.stiffness.clone();
        rest = b.restLengths.clone();
        share = b.share == null ? null : b.share.clone();
        double[] entryRest = edges.toEntries(rest);
        double[] shortening = null;
        if (share != null) {
            shortening = edges.toEntries(share);
            for (int i = 0; i < shortening.length; i++) {
                shortening[i] *= entryRest[i];
            }
        }
        constants = new SpringData(edges.toEntries(stiffness), entryRest, shortening, b.damping);
        kernel = new SpringKernel(edges, constants);
    }

    /**
     * Starts a set of springs between pairs of nodes.
     *
     * @param layout layout of the system
     * @param nodeA one end of each spring, caller's numbering
     * @param nodeB the other end
     */
    public static Builder between(NodeLayout layout, int[] nodeA, int[] nodeB) {
        return new Builder(layout, nodeA, nodeB);
    }

    /** Sets the activation a; 0 means passive. */
    public void setActivation(double value) {
        constants.activation = value;
    }

    public int count() {
        return edges.count();
    }

    /** Passive rest length of each spring, mm; a copy. */
    public double[] restLengths() {
        return rest.clone();
    }

    /**
     * Replaces the coefficients of every spring during a simulation. Allocates nothing.
     *
     * @param k stiffness of each spring, N/m
     * @param length rest length of each spring, mm; may be negative, the force is k (l - l0) in any case
     * @param shortening reduction of each rest length at full activation, mm; ignored, and may be null, if no spring is
     *     contractile
     */
    public void setCoefficients(double[] k, double[] length, double[] shortening) {
        System.arraycopy(k, 0, stiffness, 0, stiffness.length);
        System.arraycopy(length, 0, rest, 0, rest.length);
        int[] edge = edges.edge;
        for (int i = 0; i < edge.length; i++) {
            constants.stiffness[i] = k[edge[i]];
            constants.rest[i] = length[edge[i]];
        }
        constants.findRestLengthsOfZero();
        if (constants.shortening != null) {
            for (int i = 0; i < edge.length; i++) {
                constants.shortening[i] = shortening[edge[i]];
            }
            for (int e = 0; e < share.length; e++) {
                share[e] = length[e] == 0 ? 0 : shortening[e] / length[e];
            }
        }
    }

    /** Ends of each spring in the caller's numbering, two a spring. */
    public int[] callerPairs(NodeLayout layout) {
        int[] pairs = new int[2 * edges.count()];
        for (int e = 0; e < edges.count(); e++) {
            pairs[2 * e] = layout.caller(edges.nodeA[e]);
            pairs[2 * e + 1] = layout.caller(edges.nodeB[e]);
        }
        return pairs;
    }

    /** Stiffness of each spring, N/m; a copy. */
    public double[] stiffnesses() {
        return stiffness.clone();
    }

    /** Reduction of each rest length at full activation, mm; a copy. */
    public double[] shortenings() {
        double[] out = new double[rest.length];
        for (int e = 0; share != null && e < out.length; e++) {
            out[e] = share[e] * rest[e];
        }
        return out;
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        int single = edges.singleStart[block];
        int outer = edges.outerStart[block];
        int end = edges.innerStart[block + 1];
        kernel.stars(x, v, force, edges.innerStart[block], single);
        kernel.singles(x, v, force, single, outer, true);
        kernel.singles(x, v, force, outer, end, false);
    }

    @Override
    public double potentialEnergy(double[] x) {
        double sum = 0;
        for (int e = 0; e < edges.count(); e++) {
            double stretch = length(x, e) - restLengthNow(e);
            sum += 0.5 * stiffness[e] * stretch * stretch;
        }
        return sum;
    }

    private double restLengthNow(int e) {
        return rest[e] * (1 - (share == null ? 0 : constants.activation * share[e]));
    }

    private double length(double[] x, int e) {
        int a = 3 * edges.nodeA[e];
        int b = 3 * edges.nodeB[e];
        double dx = x[b] - x[a];
        double dy = x[b + 1] - x[a + 1];
        double dz = x[b + 2] - x[a + 2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /**
     * Exact along the edge. Across the edge, the geometric stiffness is included only under tension, so that K stays
     * positive semidefinite.
     */
    @Override
    public void addStiffness(double[] x, double[] u, double[] out, int block) {
        double[] restLengths = constants.rest;
        double[] shortening = constants.shortening;
        double[] k = constants.stiffness;
        double activation = constants.activation;
        int outer = edges.outerStart[block];
        int end = edges.innerStart[block + 1];
        for (int i = edges.innerStart[block]; i < end; i++) {
            int a = edges.own[i];
            int b = edges.other[i];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double squared = dx * dx + dy * dy + dz * dz;
            double ux = u[b] - u[a];
            double uy = u[b + 1] - u[a + 1];
            double uz = u[b + 2] - u[a + 2];
            if (squared == 0 && constants.isAtRestWithoutLength(i)) {
                squared = 1;
            }
            double l = restLengths[i] - (shortening == null ? 0 : activation * shortening[i]);
            double across = Math.max(0, k[i] * (1 - l / Math.sqrt(squared)));
            double along = (k[i] - across) * (ux * dx + uy * dy + uz * dz) / squared;
            double fx = along * dx + across * ux;
            double fy = along * dy + across * uy;
            double fz = along * dz + across * uz;
            out[a] -= fx;
            out[a + 1] -= fy;
            out[a + 2] -= fz;
            if (i < outer) {
                out[b] += fx;
                out[b + 1] += fy;
                out[b + 2] += fz;
            }
        }
    }

    @Override
    public void addRowSums(double[] x, double[] stiffnessSum, double[] dampingSum) {
        for (int e = 0; e < edges.count(); e++) {
            double l = restLengthNow(e);
            // A spring whose rest length is negative is stiffer across than along.
            double k = l >= 0 ? stiffness[e] : stiffness[e] * (1 - l / length(x, e));
            stiffnessSum[edges.nodeA[e]] += 2 * k;
            stiffnessSum[edges.nodeB[e]] += 2 * k;
            dampingSum[edges.nodeA[e]] += 2 * constants.damping;
            dampingSum[edges.nodeB[e]] += 2 * constants.damping;
        }
    }

    @Override
    public boolean dependsOnVelocity() {
        return constants.damping != 0;
    }

    /** Builder of a set of springs. */
    public static final class Builder {
        private final NodeLayout layout;
        private final int[] nodeA;
        private final int[] nodeB;
        private double[] stiffness;
        private double[] restLengths;
        private double[] share;
        private double damping;

        private Builder(NodeLayout layout, int[] nodeA, int[] nodeB) {
            this.layout = layout;
            this.nodeA = nodeA.clone();
            this.nodeB = nodeB.clone();
        }

        /** Sets one stiffness for all springs, N/m. */
        public Builder stiffness(double k) {
            stiffness = new double[nodeA.length];
            Arrays.fill(stiffness, k);
            return this;
        }

        /** Sets the stiffness of each spring, N/m. */
        public Builder stiffness(double[] k) {
            stiffness = k.clone();
            return this;
        }

        /** Sets one damping coefficient for all springs, N s/m; 0 for none. */
        public Builder damping(double c) {
            damping = c;
            return this;
        }

        /**
         * Sets the rest lengths to the lengths at these positions (caller's order, mm).
         *
         * @throws IllegalArgumentException if both ends of a spring coincide, so that its force has no direction
         */
        public Builder restLengthsAt(double[] positions) {
            restLengths = DenseVectors.distances(positions, nodeA, nodeB);
            for (int e = 0; e < restLengths.length; e++) {
                if (!(restLengths[e] > 0)) {
                    throw new IllegalArgumentException("spring " + e + " between nodes " + nodeA[e] + " and " + nodeB[e]
                            + ": found length " + restLengths[e] + " mm, expected more than 0");
                }
            }
            return this;
        }

        /** Sets the rest length of each spring, mm; where it is 0 the ends may coincide, and then there is no force. */
        public Builder restLengths(double[] lengths) {
            restLengths = lengths.clone();
            return this;
        }

        /** Sets the contractile share s of each spring, at least -0.5; negative where it lengthens with activation. */
        public Builder contractileShares(double[] shares) {
            share = shares.clone();
            return this;
        }

        /**
         * @throws IllegalArgumentException if a stiffness or rest length is missing, a stiffness, damping or rest
         *     length is negative or not finite, a contractile share is below -0.5 or not finite, or an edge joins a
         *     node to itself
         */
        public Springs build() {
            check("stiffness", stiffness, "N/m", 0);
            check("rest length", restLengths, "mm", 0);
            if (!(damping >= 0) || Double.isInfinite(damping)) {
                throw new IllegalArgumentException(
                        "damping of springs: found " + damping + " N s/m, expected 0 or more");
            }
            if (share != null) {
                check("contractile share", share, "", LEAST_SHARE);
            }
            return new Springs(this);
        }

        private void check(String what, double[] values, String unit, double least) {
            if (values == null || values.length != nodeA.length) {
                throw new IllegalArgumentException(what + " of springs: found "
                        + (values == null ? "none" : String.valueOf(values.length)) + ", expected " + nodeA.length);
            }
            for (int e = 0; e < values.length; e++) {
                if (!(values[e] >= least) || Double.isInfinite(values[e])) {
                    throw new IllegalArgumentException(
                            what + " of spring " + e + ": found " + (values[e] + " " + unit).strip() + ", expected "
                                    + (least == 0 ? "0" : least) + " or more");
                }
            }
        }
    }
}
