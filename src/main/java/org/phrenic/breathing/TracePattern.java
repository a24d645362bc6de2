package org.phrenic.breathing;

import java.util.Arrays;

/**
 * Breathing as it was recorded.
 *
 * <p>The trace is normalised (0 at its 5th, 1 at its 95th percentile), cut to begin and end near end-expiration, kept from 0 to
 * what the body can do, and joined by monotone cubics. Its first and last {@value #FADE_S} s are faded, so that it starts and
 * ends exactly at end-expiration; at its end it rests there or begins again.
 */
public final class TracePattern implements BreathingPattern {
    private static final double FADE_S = 0.5;

    /** A sample below this share of a breath is near end-expiration. */
    private static final double NEAR_REST = 0.15;

    /** A breath begins at the lowest point before the signal rises above this, having been near rest. */
    private static final double CLEARLY_IN = 0.4;

    private final String name;
    private final boolean loops;
    private final double durationS;
    private final MonotoneCubic curve;
    private final double[] onsetsS;
    private final Drive drive;

    /**
     * A recorded pattern.
     *
     * @param trace the recording; detrend it before where it drifts
     * @param parameters depth at the 95th percentile; its rate and fractions mean nothing here
     * @param loops whether it begins again at its end, or rests
     * @throws IllegalArgumentException if the signal does not change or is too short to fade
     */
    public TracePattern(Trace trace, BreathingParameters parameters, boolean loops) {
        this.loops = loops;
        name = trace.name();
        drive = new Drive(parameters);
        double[] amplitude = trace.normalised().amplitude();
        int first = 0;
        int last = amplitude.length - 1;
        while (first < last && amplitude[first] > NEAR_REST) {
            first++;
        }
        while (last > first && amplitude[last] > NEAR_REST) {
            last--;
        }
        double startS = trace.timeS()[first];
        durationS = trace.timeS()[last] - startS;
        if (!(durationS > 2 * FADE_S)) {
            throw new IllegalArgumentException(name + ": " + durationS
                    + " s from the first to the last end-expiration, " + "expected more than " + 2 * FADE_S + " s");
        }
        double deepest = drive.deepest();
        double[] timeS = new double[last - first + 1];
        double[] depth = new double[timeS.length];
        for (int i = 0; i < timeS.length; i++) {
            timeS[i] = trace.timeS()[first + i] - startS;
            depth[i] = Math.max(0, Math.min(deepest, amplitude[first + i]));
        }
        curve = new MonotoneCubic(timeS, depth);
        onsetsS = onsets(timeS, depth);
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double periodS() {
        return loops ? durationS : Double.POSITIVE_INFINITY;
    }

    @Override
    public void at(double timeS, BreathState state) {
        double rounds = Math.max(0, timeS / durationS);
        boolean over = timeS < 0 || (!loops && rounds >= 1);
        int round = loops ? (int) rounds : 0;
        double t = Math.min((rounds - round) * durationS, durationS);
        place(t, round, state);
        double raw = curve.value(t);
        double in = SmoothStep.value(t / FADE_S);
        double out = SmoothStep.value((durationS - t) / FADE_S);
        double fadeRate =
                (SmoothStep.slope(t / FADE_S) * out - SmoothStep.slope((durationS - t) / FADE_S) * in) / FADE_S;
        double depth = raw * in * out;
        double rate = curve.slope(t) * in * out + raw * fadeRate;
        drive.write(depth, rate, state);
        if (over) {
            state.rest(BreathLabel.PAUSE);
        } else if (rate == 0 && depth == 0) {
            state.label = BreathLabel.PAUSE;
        } else {
            state.label = rate > 0 ? BreathLabel.INSPIRATION : BreathLabel.EXPIRATION;
        }
    }

    /** Breaths found in one round of the trace. */
    public int breaths() {
        return onsetsS.length - 1;
    }

    private void place(double t, int round, BreathState state) {
        int found = Arrays.binarySearch(onsetsS, t);
        int breath = Math.max(0, Math.min(found >= 0 ? found : -found - 2, onsetsS.length - 2));
        state.breath = round * breaths() + breath;
        state.phase = Math.min((t - onsetsS[breath]) / (onsetsS[breath + 1] - onsetsS[breath]), Math.nextDown(1.0));
    }

    /** Where each breath begins, and the end of the last. */
    private static double[] onsets(double[] timeS, double[] depth) {
        double[] found = new double[timeS.length + 1];
        int count = 0;
        int lowest = 0;
        boolean armed = true;
        for (int i = 0; i < depth.length; i++) {
            if (armed && depth[i] > CLEARLY_IN) {
                // The first breath has everything before it.
                found[count] = count == 0 ? 0 : timeS[lowest];
                count++;
                armed = false;
            } else if (!armed && depth[i] < NEAR_REST) {
                armed = true;
                lowest = i;
            } else if (armed && depth[i] <= depth[lowest]) {
                lowest = i;
            }
        }
        if (count == 0) {
            count = 1;
        }
        found[count] = timeS[timeS.length - 1];
        return Arrays.copyOf(found, count + 1);
    }
}
