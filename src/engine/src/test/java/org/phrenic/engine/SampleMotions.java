package org.phrenic.engine;

import java.util.Arrays;

/** Given motions for tests. */
public final class SampleMotions {
    private SampleMotions() {}

    /** Points that swing together from where they are: shift = amplitude sin(Ω t) along an axis, mm, rad/s. */
    public static PrescribedMotion swinging(double[] start, int axis, double amplitude, double angularFrequency) {
        double[] from = start.clone();
        return new PrescribedMotion() {
            @Override
            public int pointCount() {
                return from.length / 3;
            }

            @Override
            public void at(double time, double[] position, double[] velocity) {
                System.arraycopy(from, 0, position, 0, from.length);
                Arrays.fill(velocity, 0, from.length, 0);
                for (int i = axis; i < from.length; i += 3) {
                    position[i] += amplitude * Math.sin(angularFrequency * time);
                    velocity[i] = amplitude * angularFrequency * Math.cos(angularFrequency * time);
                }
            }
        };
    }
}
