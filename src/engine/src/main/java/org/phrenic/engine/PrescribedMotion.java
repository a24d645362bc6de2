package org.phrenic.engine;

/** Points whose motion is given as a function of time, such as anchors on ribs or nodes fixed to bone. */
public interface PrescribedMotion {

    /** Number of points. */
    int pointCount();

    /**
     * Positions and velocities at a time; called on one thread, allocates nothing.
     *
     * @param time simulated time, s
     * @param position three numbers a point, mm
     * @param velocity three numbers a point, mm/s
     */
    void at(double time, double[] position, double[] velocity);

    /** Saves what the motion depends on besides time and the state of the system; allocates nothing. */
    default void saveMotion() {}

    /** Restores what {@link #saveMotion} saved last. */
    default void restoreMotion() {}

    /** Whether the points never move. They are then evaluated once. */
    default boolean isStationary() {
        return false;
    }

    /** Points at constant positions. */
    static PrescribedMotion stationary(double[] positions) {
        double[] fixed = positions.clone();
        return new PrescribedMotion() {
            @Override
            public int pointCount() {
                return fixed.length / 3;
            }

            @Override
            public boolean isStationary() {
                return true;
            }

            @Override
            public void at(double time, double[] position, double[] velocity) {
                System.arraycopy(fixed, 0, position, 0, fixed.length);
                java.util.Arrays.fill(velocity, 0, fixed.length, 0);
            }
        };
    }
}
