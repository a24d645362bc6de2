package org.phrenic.breathing;

/**
 * A value that goes smoothly from one to another, for parameters changed while the simulation runs. See
 * {@link #DEFAULT_S}.
 *
 * @param from value until the start
 * @param to value after the end
 * @param startS when it starts, s
 * @param durationS how long it takes, s, above 0
 */
public record Ramp(double from, double to, double startS, double durationS) {
    /** Long against a time step, short to the eye. */
    public static final double DEFAULT_S = 0.2;

    public Ramp {
        if (!(durationS > 0)) {
            throw new IllegalArgumentException("ramp: duration " + durationS + " s, expected more than 0");
        }
    }

    /** A ramp of {@value #DEFAULT_S} s. */
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

    /** Whether it has arrived. */
    public boolean isDone(double timeS) {
        return timeS >= startS + durationS;
    }
}
