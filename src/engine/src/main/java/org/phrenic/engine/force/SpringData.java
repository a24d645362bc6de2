package org.phrenic.engine.force;

/** Constants of springs, one an entry of {@link org.phrenic.engine.parallel.BlockedEdges}. */
final class SpringData {
    /** N/m. */
    final double[] stiffness;
    /** When passive, mm. */
    final double[] rest;
    /** What full activation takes from the rest length, mm; null where nothing is contractile. */
    final double[] shortening;
    /**
     * Of contractile springs with dashpots at the activation of the last {@link #updateRest}, mm; of others the passive
     * array.
     */
    final double[] currentRest;
    /** N s/m, of every spring; 0 without dashpots. */
    final double damping;

    double activation;

    SpringData(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.currentRest = shortening == null || damping == 0 ? rest : rest.clone();
        this.damping = damping;
    }

    /** Brings the current rest lengths of the entries {@code [from, to)} to the activation. */
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
