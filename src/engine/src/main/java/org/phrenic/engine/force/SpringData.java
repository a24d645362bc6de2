package org.phrenic.engine.force;

/** Coefficients of springs, one for each entry of {@link org.phrenic.engine.parallel.BlockedEdges}. */
final class SpringData {
    /** Stiffness, N/m. */
    final double[] stiffness;
    /** Passive rest length, mm. */
    final double[] rest;
    /** Reduction of the rest length at full activation, mm; null if no spring is contractile. */
    final double[] shortening;
    /**
     * Rest length at the activation of the last {@link #updateRest}, mm. Used by contractile springs with dashpots; for
     * others it is the passive array.
     */
    final double[] currentRest;
    /** Damping coefficient of every spring, N s/m; 0 without dashpots. */
    final double damping;

    double activation;

    SpringData(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.currentRest = shortening == null || damping == 0 ? rest : rest.clone();
        this.damping = damping;
    }

    /** Updates the current rest lengths of the entries {@code [from, to)} to the activation. */
    void updateRest(int from, int to) {
        if (currentRest != rest) {
            contract(currentRest, rest, shortening, activation, from, to);
        }
    }

    private static void contract(double[] out, double[] rest, double[] share, double a, int from, int to) {
        for (int i = from; i < to; i++) {
            out[i] = rest[i] - a * share[i];
        }
    }
}
