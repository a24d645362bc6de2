package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/**
 * Records the body at evenly spaced moments of one breath, or of the breaths of a pattern that repeats after several.
 * {@link CycleRecorder} does the same during a live run.
 */
public final class BreathCycle {
    /** Usual number of moments of a breath. */
    public static final int PHASES = 20;
    /** Maximum number of moments of several breaths. */
    static final int MAX_MOMENTS = 160;
    /** Maximum recording time, s, of a pattern or, without a period, of the duration of the scenario. */
    private static final double MAX_DURATION_S = 40;
    /** Moments of a breath below which its depth may be missed. */
    private static final int FEWEST_MOMENTS = 8;

    /** A moment is recorded at the nearest step, s. */
    private static final double SAME_TIME_S = 0.1;

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private BreathCycle() {}

    /**
     * Simulates one period of the breathing from the current state and records it.
     *
     * @param phases number of moments of a breath; the first is the current time, the last is one interval before the
     *     end of the period
     */
    public static List<BreathMoment> record(Simulation simulation, SceneSurfaces surfaces, int phases) {
        double start = simulation.time();
        double recordedS = recordedS(simulation.breathDurationS());
        int count = moments(phases, simulation.scene().drive().pattern().breathsBetween(start, start + recordedS));
        List<BreathMoment> moments = new ArrayList<>();
        Frame frame = surfaces.newFrame();
        for (int i = 0; i < count; i++) {
            double dt = simulation.stepper().dt();
            while (!isDue(simulation.time() - start, dt, recordedS, i, count)) {
                simulation.step();
            }
            surfaces.capture(frame);
            moments.add(new BreathMoment(frame.copy(), simulation.breathLabel()));
        }
        return moments;
    }

    /** How much of a period of the breathing is recorded, s. */
    static double recordedS(double periodS) {
        return Math.min(periodS, MAX_DURATION_S);
    }

    /** Number of moments of so many breaths: that of a breath for each, as far as there is memory for them. */
    static int moments(int phases, int breaths) {
        return Math.max(phases, Math.min(phases * breaths, MAX_MOMENTS));
    }

    /** Whether the next moment is due, {@code sinceS} seconds after the first. */
    static boolean isDue(double sinceS, double dtS, double recordedS, int moment, int count) {
        return sinceS >= recordedS * moment / count - 0.5 * dtS;
    }

    /**
     * What a judgement by recorded moments may miss, as one sentence without a full stop: breaths after the longest
     * recording, and depths between moments that are more than an eighth of a breath apart; empty for neither.
     */
    public static Optional<String> limits(List<BreathMoment> moments) {
        int count = moments.size();
        if (count < 2) {
            return Optional.empty();
        }
        Frame last = moments.get(count - 1).frame();
        double spanS = (last.timeS() - moments.get(0).timeS()) * count / (count - 1);
        double breaths = 1 + last.values()[BREATH] - moments.get(0).frame().values()[BREATH];
        boolean cut = spanS > MAX_DURATION_S - SAME_TIME_S;
        boolean sparse = breaths > 1 && count < FEWEST_MOMENTS * breaths;
        return cut || sparse
                ? Optional.of(Numbers.format(
                        "judged at %d moments of the first %.0f s, %.1f a breath", count, spanS, count / breaths))
                : Optional.empty();
    }
}
