package org.phrenic.breathing.pattern;

import java.nio.file.Path;
import java.util.Arrays;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingTrace;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.Smootherstep;
import org.phrenic.file.Numbers;

/**
 * Breathing from a recorded trace.
 *
 * <p>The trace is normalised (0 at the 5th, 1 at the 95th percentile), trimmed to begin and end near end-expiration,
 * clamped to the possible range of depth and interpolated by monotone cubics. Its first and last {@value #FADE_S} s are
 * faded, so that it starts and ends exactly at end-expiration. After its end it rests or repeats. A breath is
 * inspiration up to its highest sample and expiration from there, whatever noise does to the slope.
 */
public final class TracePattern implements BreathingPattern {
    private static final double FADE_S = 0.5;
    /** Digits of the range of a trace that are stated. */
    private static final int SCALE_DIGITS = 3;

    /** Minimum rise and fall of a breath as a fraction of a typical one. Smaller peaks are noise or cardiac motion. */
    private static final double PROMINENCE = 0.4;
    /** Rise of an end of the recording over the next end-expiration beyond which it lies within a breath. */
    private static final double CUT = 0.2;
    /** Share of a breath at an end of the recording within which the signal moves by {@link #MOVING} or rests. */
    private static final double MOVING_SHARE = 0.1;
    /** The same of a recording of few samples a breath: over three of them. */
    private static final double LEAST_SPACINGS = 2.5;

    private static final double MOVING = 0.05;

    private final BreathingTrace trace;
    private final boolean loops;
    private final double startS;
    private final double durationS;
    private final MonotoneCubic curve;
    private final double[] onsetsS;
    private final double[] peaksS;
    private final RespiratoryDrive drive;

    /**
     * @param trace recording; remove any drift beforehand
     * @param parameters depth at the 95th percentile; rate and fractions are ignored
     * @param loops true to repeat the trace, false to rest after its end
     * @throws IllegalArgumentException if the signal is constant or too short to fade
     */
    public TracePattern(BreathingTrace trace, BreathingParameters parameters, boolean loops) {
        this.loops = loops;
        this.trace = trace;
        drive = new RespiratoryDrive(parameters);
        double[] amplitude = trace.normalised().amplitude();
        int[] restful = endExpirations(amplitude, trace.timeS());
        int first = restful[0];
        int last = restful[restful.length - 1];
        startS = trace.timeS()[first];
        durationS = trace.timeS()[last] - startS;
        if (!(durationS > 2 * FADE_S)) {
            throw new IllegalArgumentException(trace.name() + ": " + durationS
                    + " s from the first to the last end-expiration, " + "expected more than " + 2 * FADE_S + " s");
        }
        double deepest = drive.maxDepth();
        double[] timeS = new double[last - first + 1];
        double[] depth = new double[timeS.length];
        for (int i = 0; i < timeS.length; i++) {
            timeS[i] = trace.timeS()[first + i] - startS;
            depth[i] = Math.max(0, Math.min(deepest, amplitude[first + i]));
        }
        curve = new MonotoneCubic(timeS, depth);
        onsetsS = new double[restful.length];
        Arrays.setAll(onsetsS, i -> timeS[restful[i] - first]);
        peaksS = new double[restful.length - 1];
        Arrays.setAll(peaksS, i -> timeS[highest(amplitude, restful[i], restful[i + 1]) - first]);
    }

    @Override
    public double periodS() {
        return loops ? durationS : Double.POSITIVE_INFINITY;
    }

    /** Duration of the recording, played once. */
    @Override
    public double fullDurationS() {
        return durationS;
    }

    @Override
    public void at(double timeS, BreathState state) {
        double rounds = Math.max(0, timeS / durationS);
        boolean over = timeS < 0 || (!loops && rounds >= 1);
        int round = loops ? (int) rounds : 0;
        double t = Math.min((rounds - round) * durationS, durationS);
        int breath = setPlace(t, round, state);
        double raw = curve.value(t);
        double in = Smootherstep.value(t / FADE_S);
        double out = Smootherstep.value((durationS - t) / FADE_S);
        double fadeRate =
                (Smootherstep.slope(t / FADE_S) * out - Smootherstep.slope((durationS - t) / FADE_S) * in) / FADE_S;
        double depth = raw * in * out;
        double rate = curve.slope(t) * in * out + raw * fadeRate;
        drive.write(depth, rate, state);
        if (over) {
            state.setAtRest(RespiratoryPhase.PAUSE);
        } else if (rate == 0 && depth == 0) {
            state.respiratoryPhase = RespiratoryPhase.PAUSE;
        } else {
            state.respiratoryPhase = t < peaksS[breath] ? RespiratoryPhase.INSPIRATION : RespiratoryPhase.EXPIRATION;
        }
    }

    /** Time of the recording at its first end-expiration, where the pattern begins, s. */
    public double startS() {
        return startS;
    }

    /** Number of breaths in one pass of the trace. */
    public int breaths() {
        return onsetsS.length - 1;
    }

    /** What was read from the recording, and how it is breathed: signal, scale, number, begin and period of breaths. */
    public String description() {
        double low = trace.percentile(BreathingTrace.BASELINE_PERCENT);
        double high = trace.percentile(BreathingTrace.PEAK_PERCENT);
        int decimals = Math.max(0, SCALE_DIGITS - 1 - (int) Math.floor(StrictMath.log10(high - low)));
        String value = "%." + decimals + "f";
        String text = "%s: %s; depth 0 at " + value + ", 1 at " + value
                + " (%.0fth and %.0fth percentile); %d %s in %.1f s from %.2f s of the recording on, %.1f s each%s;"
                + " rate and inspiratory fraction are those of the recording";
        return Numbers.format(
                text,
                Path.of(trace.name()).getFileName(),
                trace.signal(),
                low,
                high,
                BreathingTrace.BASELINE_PERCENT,
                BreathingTrace.PEAK_PERCENT,
                breaths(),
                breaths() == 1 ? "breath" : "breaths",
                durationS,
                startS,
                durationS / breaths(),
                loops ? ", then again from the first" : "");
    }

    /** Sets breath and phase; returns the number of the breath within the recording. */
    private int setPlace(double t, int round, BreathState state) {
        int found = Arrays.binarySearch(onsetsS, t);
        int breath = Math.max(0, Math.min(found >= 0 ? found : -found - 2, onsetsS.length - 2));
        state.breath = round * breaths() + breath;
        state.phase = Math.min((t - onsetsS[breath]) / (onsetsS[breath + 1] - onsetsS[breath]), Math.nextDown(1.0));
        return breath;
    }

    private static int highest(double[] depth, int from, int to) {
        int highest = from;
        for (int i = from; i <= to; i++) {
            highest = depth[i] > depth[highest] ? i : highest;
        }
        return highest;
    }

    /**
     * Indices of the lowest sample before each breath and after the last; the first and last sample if there are no
     * breaths. Breaths are detected by prominence, not by level, because the level drifts. A breath within which the
     * recording begins or ends is left out if another is left.
     */
    private static int[] endExpirations(double[] depth, double[] timeS) {
        int[] found = troughs(depth);
        int first = found.length > 2 && isWithinBreath(depth, timeS, 0, found[0], found[1]) ? 1 : 0;
        int last = found.length - 1;
        if (last - first > 1 && isWithinBreath(depth, timeS, depth.length - 1, found[last], found[last - 1])) {
            last--;
        }
        return Arrays.copyOfRange(found, first, last + 1);
    }

    /**
     * Whether an outer trough only ends the recording: it lies clearly above the next one, no sample from the end of
     * the recording to it lies clearly above it, and the signal moves at that end.
     */
    private static boolean isWithinBreath(double[] depth, double[] timeS, int end, int trough, int next) {
        double highest = depth[highest(depth, Math.min(end, trough), Math.max(end, trough))];
        return depth[trough] > depth[next] + CUT
                && highest < depth[trough] + CUT
                && isMoving(depth, timeS, end, MOVING_SHARE * Math.abs(timeS[trough] - timeS[next]));
    }

    /** Whether the mean of the signal changes from one half of a time at an end of the recording to the other. */
    private static boolean isMoving(double[] depth, double[] timeS, int end, double withinS) {
        double spacingS = Math.abs(timeS[end] - timeS[end == 0 ? 1 : end - 1]);
        double overS = Math.max(withinS, LEAST_SPACINGS * spacingS);
        double[] sum = new double[2];
        int[] count = new int[2];
        for (int i = 0; i < depth.length; i++) {
            double share = Math.abs(timeS[i] - timeS[end]) / overS;
            if (share < 1) {
                int half = share < 0.5 ? 0 : 1;
                sum[half] += depth[i];
                count[half]++;
            }
        }
        return count[1] > 0 && Math.abs(sum[0] / count[0] - sum[1] / count[1]) > MOVING;
    }

    private static int[] troughs(double[] depth) {
        int[] found = new int[depth.length + 2];
        int count = 0;
        boolean rising = false;
        int extreme = 0;
        for (int i = 0; i < depth.length; i++) {
            if (rising ? depth[i] > depth[extreme] : depth[i] <= depth[extreme]) {
                extreme = i;
            } else if (Math.abs(depth[i] - depth[extreme]) > PROMINENCE) {
                if (!rising) {
                    found[count++] = extreme;
                }
                rising = !rising;
                extreme = i;
            }
        }
        if (!rising && count > 0) {
            found[count++] = extreme;
        }
        return count < 2 ? new int[] {0, depth.length - 1} : Arrays.copyOf(found, count);
    }
}
