package org.phrenic.breathing;

import java.util.ArrayList;
import java.util.List;

/**
 * Warped time for breathing that can be paused: it advances with simulated time, slows smoothly to a stop and resumes.
 *
 * <p>{@code tau(t) = tau_0 + r_0 (t - t_0) + (r_1 - r_0) D I((t - t_0) / D)}, with rate {@code r} (1 running, 0
 * stopped), ramp duration {@code D} and the integral {@code I} of the smootherstep. Tau and its rate are continuous.
 * Tau depends on the rate changes only, not on the time steps.
 */
public final class TimeWarp {
    /** A change of rate that begins at {@code startS}, where warped time is {@code tauS}. */
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

    /** @param runs true if warped time runs from the start, false if it stays at 0 */
    public TimeWarp(boolean runs) {
        this.runs = runs;
    }

    /**
     * Starts or stops warped time at a given time; replaces a change at the same time.
     *
     * @param rampS duration of the transition, s, above 0
     */
    public void setRunning(boolean go, double nowS, double rampS) {
        if (!turns.isEmpty() && turns.get(turns.size() - 1).startS() == nowS) {
            turns.remove(turns.size() - 1);
        }
        turns.add(new RateChange(nowS, warpedTime(nowS), rate(nowS), go ? 1 : 0, rampS));
    }

    /** Warped time at a simulated time, s. */
    public double warpedTime(double timeS) {
        RateChange turn = changeAt(timeS);
        return turn != null ? turn.tau(timeS) : runs ? timeS : 0;
    }

    /** Rate of warped time at a simulated time, 0 to 1. */
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
