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
    /** Whether some passive rest length is 0, so that the ends of a spring may coincide. */
    boolean mayCoincide;

    SpringData(double[] stiffness, double[] rest, double[] shortening, double damping) {
        this.stiffness = stiffness;
        this.rest = rest;
        this.shortening = shortening;
        this.damping = damping;
        findRestLengthsOfZero();
    }

    /** Call it after rest lengths were changed. */
    void findRestLengthsOfZero() {
        mayCoincide = false;
        for (double l : rest) {
            mayCoincide |= l == 0;
        }
    }

    /** Whether a spring with ends in one place has no force, and so needs no direction. */
    boolean isAtRestWithoutLength(int entry) {
        return rest[entry] == 0 && (shortening == null || activation * shortening[entry] == 0);
    }
}
