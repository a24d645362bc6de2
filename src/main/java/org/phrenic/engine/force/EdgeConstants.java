package org.phrenic.engine.force;

/** The numbers of springs as passes over edges read them: one an entry of {@link BlockedEdges}, with room behind the last for a whole vector. */
final class EdgeConstants {
    /** N/m. */
    final double[] stiffness;
    /** When passive, mm. */
    final double[] rest;
    /** What full activation takes from the rest length, mm; null where nothing is contractile. */
    final double[] shortening;
    /** Rest length at the activation of the last {@link #contract}, mm: for contractile springs with dashpots; for others the passive one itself. */
    final double[] current;
    /** N s/m, of every spring; 0 without dashpots. */
    final double damping;

    /** Whether all springs have one stiffness: vector instructions then read it once. */
    boolean oneStiffness;

    double activation;

    EdgeConstants(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.current = shortening == null || damping == 0 ? rest : rest.clone();
        this.damping = damping;
    }

    /** Brings the current rest lengths of the entries {@code [from, to)} to the activation. */
    void contract(int from, int to) {
        if (shortening != null) {
            contract(current, rest, shortening, activation, from, to);
        }
    }

    private static void contract(double[] current, double[] rest, double[] share, double a, int from, int to) {
        for (int i = from; i < to; i++) {
            current[i] = rest[i] - a * share[i];
        }
    }
}
