package org.phrenic.engine.force;

/** Coefficients of springs, one for each entry of {@link org.phrenic.engine.parallel.BlockedEdges}. */
final class SpringData {
    /** Stiffness, N/m. */
    final double[] stiffness;
    /** Passive rest length, mm. */
    final double[] rest;
    /** Reduction of the rest length at full activation, mm; null if no spring is contractile. */
    final double[] shortening;
    /** Damping coefficient of every spring, N s/m; 0 without dashpots. */
    final double damping;

    double activation;

    SpringData(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.damping = damping;
    }
}
