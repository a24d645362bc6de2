package org.phrenic.model.assembly;

/**
 * Masses of the nodes of a scene, in the caller's order: what the tissue weighs, and the least mass that lets a node's
 * springs bear the time step. A node has the greater of the two.
 */
public final class NodeMasses {
    private final double[] tissue;
    private final double[] least;

    /**
     * @param tissue mass of the tissue, kg, one a node
     * @param least least mass, kg, one a node; 0 for none
     */
    public NodeMasses(double[] tissue, double[] least) {
        this.tissue = tissue.clone();
        this.least = least.clone();
    }

    /**
     * Mass of a node, kg.
     *
     * @param density factor of the tissue's area density
     * @param tissueFactor further factor of the tissue's mass
     * @param leastFactor factor of the least mass
     */
    public double of(int node, double density, double tissueFactor, double leastFactor) {
        return Math.max(tissueFactor * (density * tissue[node]), leastFactor * least[node]);
    }

    /** Masses of all nodes, kg. */
    public double[] all() {
        double[] out = new double[tissue.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = of(i, 1, 1, 1);
        }
        return out;
    }

    /** Mass that nodes have beyond that of the tissue, per cent of it. */
    public double addedPercent() {
        double before = 0;
        double added = 0;
        for (int i = 0; i < tissue.length; i++) {
            before += tissue[i];
            added += Math.max(0, least[i] - tissue[i]);
        }
        return 100 * added / before;
    }
}
