package org.phrenic.engine;

/** Points whose motion is given, not computed: anchors on ribs, nodes held by bone. */
public interface PrescribedMotion {

    /** How many points. */
    int pointCount();

    /**
     * Positions and velocities at a time; called on one thread, allocates nothing.
     *
     * @param time simulated time, s
     * @param position three numbers a point, mm
     * @param velocity three numbers a point, mm/s
     */
    void at(double time, double[] position, double[] velocity);

    /** Whether the points are at the same places, at rest, at all times: they are then asked for once. */
    default boolean isStationary() {
        return false;
    }

    /** Points that stay where they are. */
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
