package org.phrenic.breathing;

/**
 * A smooth transition between two values, for parameters that change during a simulation. See {@link #DEFAULT_S}.
 *
 * @param from value before the start
 * @param to value after the end
 * @param startS start time, s
 * @param durationS duration, s, above 0
 */
public record Ramp(double from, double to, double startS, double durationS) {
    /** Default duration, s: many time steps, but short for a viewer. */
    public static final double DEFAULT_S = 0.2;

    public Ramp {
        if (!(durationS > 0)) {
            throw new IllegalArgumentException("ramp: duration " + durationS + " s, expected more than 0");
        }
    }

    /** Creates a ramp of {@value #DEFAULT_S} s. */
    public static Ramp of(double from, double to, double startS) {
        return new Ramp(from, to, startS, DEFAULT_S);
    }

    /** Value at a time. */
    public double at(double timeS) {
        return from + (to - from) * Smootherstep.value((timeS - startS) / durationS);
    }

    /** Derivative at a time, 1/s. */
    public double rate(double timeS) {
        return (to - from) / durationS * Smootherstep.slope((timeS - startS) / durationS);
    }

    /** True once the ramp has ended. */
    public boolean isDone(double timeS) {
        return timeS >= startS + durationS;
    }
}
