package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.Numbers;
import org.phrenic.model.assembly.LiveBreathing;
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
    /** Moments of a breath, outside of pauses and holds, below which its depth may be missed. */
    private static final int FEWEST_MOMENTS = 8;

    /** Periods that differ by less are one, s. */
    private static final double SAME_PERIOD_S = 1e-6;

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
        double periodS = simulation.breathDurationS();
        double recordedS = recordedS(periodS);
        LiveBreathing breathing = simulation.scene().drive().pattern();
        int count = moments(phases, recordedS, breathing.shortestBreathS(start, start + recordedS));
        List<BreathMoment> moments = new ArrayList<>();
        Frame frame = surfaces.newFrame();
        for (int i = 0; i < count; i++) {
            double dt = simulation.stepper().dt();
            while (!isDue(simulation.time() - start, dt, recordedS, i, count)) {
                simulation.step();
            }
            surfaces.capture(frame);
            moments.add(new BreathMoment(frame.copy(), simulation.breathLabel(), periodS));
        }
        return moments;
    }

    /** How much of a period of the breathing is recorded, s. */
    static double recordedS(double periodS) {
        return Math.min(periodS, MAX_DURATION_S);
    }

    /** Number of moments of a recording: so many of its shortest breath, as far as there is memory for them. */
    static int moments(int phases, double recordedS, double shortestBreathS) {
        return Math.max(phases, (int) Math.min(Math.round(phases * recordedS / shortestBreathS), MAX_MOMENTS));
    }

    /** Whether the next moment is due, {@code sinceS} seconds after the first. */
    static boolean isDue(double sinceS, double dtS, double recordedS, int moment, int count) {
        return sinceS >= recordedS * moment / count - 0.5 * dtS;
    }

    /**
     * What a judgement by recorded moments may miss, as one sentence without a full stop: breaths after the longest
     * recording, and depths of a breath with few moments outside of pauses and holds; empty for neither.
     */
    public static Optional<String> limits(List<BreathMoment> moments) {
        int count = moments.size();
        if (count == 0) {
            return Optional.empty();
        }
        Map<Integer, Integer> moving = new TreeMap<>();
        int last = 0;
        for (BreathMoment moment : moments) {
            last = (int) moment.frame().values()[BREATH];
            if (moment.label() == RespiratoryPhase.INSPIRATION || moment.label() == RespiratoryPhase.EXPIRATION) {
                moving.merge(last, 1, Integer::sum);
            }
        }
        boolean chosen = moving.size() < 2 && count < FEWEST_MOMENTS;
        double periodS = moments.get(0).periodS();
        boolean cut = periodS > MAX_DURATION_S + SAME_PERIOD_S;
        if (cut && moving.size() > 1) {
            moving.remove(last);
        }
        int least = moving.values().stream().min(Integer::compare).orElse(count);
        return cut || (least < FEWEST_MOMENTS && !chosen)
                ? Optional.of(Numbers.format(
                        "judged at %d moments of %s%.0f s, at least %d of each breath outside of pauses and holds",
                        count, cut ? "the first " : "", recordedS(periodS), least))
                : Optional.empty();
    }
}
