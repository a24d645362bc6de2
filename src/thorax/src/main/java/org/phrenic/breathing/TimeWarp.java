package org.phrenic.breathing;

import java.util.ArrayList;
import java.util.List;

/**
 * The time of a breath that can be held: it runs with simulated time, slows smoothly to a stop and starts again.
 *
 * <p>{@code tau(t) = tau_0 + r_0 (t - t_0) + (r_1 - r_0) D I((t - t_0) / D)}, {@code r} its rate (1 goes, 0 stands),
 * {@code D} the ramp and {@code I} the integral of the smooth step; so tau and its rate are continuous, and tau is a
 * function of the changes alone, not of the steps between.
 */
public final class TimeWarp {
    /** From {@code startS}, where the clock shows {@code tauS}, the rate goes from one value to another. */
    private record RateChange(double startS, double tauS, double from, double to, double rampS) {
        double tau(double timeS) {
            double t = timeS - startS;
            return tauS + from * t + (to - from) * rampS * Smootherstep.integral(t / rampS);
        }

        double rate(double timeS) {
            return from + (to - from) * Smootherstep.value((timeS - startS) / rampS);
        }
    }

    private final boolean runs;
    private final List<RateChange> turns = new ArrayList<>();

    /** @param runs whether it runs from the start, or stands at 0 */
    public TimeWarp(boolean runs) {
        this.runs = runs;
    }

    /**
     * Starts or stops warped time from a time on; a change at the same time is replaced.
     *
     * @param rampS how long it takes, s, above 0
     */
    public void setRunning(boolean go, double nowS, double rampS) {
        if (!turns.isEmpty() && turns.get(turns.size() - 1).startS() == nowS) {
            turns.remove(turns.size() - 1);
        }
        turns.add(new RateChange(nowS, warpedTime(nowS), rate(nowS), go ? 1 : 0, rampS));
    }

    /** Warped time at a time, s. */
    public double warpedTime(double timeS) {
        RateChange turn = changeAt(timeS);
        return turn != null ? turn.tau(timeS) : runs ? timeS : 0;
    }

    /** Rate of warped time at a time, 0 to 1. */
    public double rate(double timeS) {
        RateChange turn = changeAt(timeS);
        return turn != null ? turn.rate(timeS) : runs ? 1 : 0;
    }

    private RateChange changeAt(double timeS) {
        for (int i = turns.size() - 1; i >= 0; i--) {
            if (timeS >= turns.get(i).startS()) {
                return turns.get(i);
            }
        }
        return null;
    }
}
