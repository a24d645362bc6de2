package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/**
 * The numbers of springs as passes over edges read them: one an entry of {@link BlockedEdges}, with room behind the
 * last for a whole vector.
 */
final class SpringData {
    /** N/m. */
    final double[] stiffness;
    /** When passive, mm. */
    final double[] rest;
    /** What full activation takes from the rest length, mm; null where nothing is contractile. */
    final double[] shortening;
    /**
     * Rest length at the activation of the last {@link #updateRest}, mm: for contractile springs with dashpots; for
     * others the passive one itself.
     */
    final double[] currentRest;
    /** N s/m, of every spring; 0 without dashpots. */
    final double damping;

    /** Whether all springs have one stiffness: vector instructions then read it once. */
    boolean oneStiffness;

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
        if (shortening != null) {
            updateRest(currentRest, rest, shortening, activation, from, to);
        }
    }

    private static void updateRest(double[] current, double[] rest, double[] share, double a, int from, int to) {
        for (int i = from; i < to; i++) {
            current[i] = rest[i] - a * share[i];
        }
    }
}
