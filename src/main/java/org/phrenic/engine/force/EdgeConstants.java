package org.phrenic.engine.force;

/** The numbers of springs as passes over edges read them: one an entry of {@link BlockedEdges}, with room behind the last for a whole vector. */
final class EdgeConstants {
    /** N/m. */
    final double[] stiffness;
    /** mm. */
    final double[] rest;
    /** What full activation takes from the rest length, mm; null where nothing is contractile. */
    final double[] shortening;
    /** N s/m, of every spring; 0 without dashpots. */
    final double damping;

    /** Whether all springs have one stiffness: then it is read once a batch. */
    boolean oneStiffness;

    double activation;

    EdgeConstants(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.damping = damping;
    }
}
