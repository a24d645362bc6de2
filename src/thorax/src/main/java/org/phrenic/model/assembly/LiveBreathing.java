package org.phrenic.model.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.TimeWarp;
import org.phrenic.breathing.pattern.BlendedPattern;
import org.phrenic.breathing.pattern.TimeWarpedPattern;
import org.phrenic.parameter.SettingValues;

/**
 * Breathing pattern that can change during a run. Another preset starts from its beginning; another rate, depth or
 * balance continues at the same phase; the breath can be held. The result is a function of the time and of the changes
 * made.
 */
public final class LiveBreathing implements BreathingPattern {
    /** The last pattern, the same at warped time, and its blend with those before it. */
    private record State(BreathingPattern base, TimeWarpedPattern warped, BreathingPattern pattern) {}

    /** Phases that differ by less are one. */
    private static final double SAME_PHASE = 1e-9;
    /** Times that differ by less are one, s. */
    private static final double SAME_TIME_S = 1e-6;
    /** Spacing of the times at which breaths are looked for, s. */
    private static final double SEARCH_S = 1e-3;

    private final TimeWarp clock;
    private final List<Double> cutShortS = new ArrayList<>();
    private State state;
    private State previous;
    private long changedAtStep = -1;

    public LiveBreathing(SettingValues settings) {
        clock = new TimeWarp(!settings.get(Breathing.HOLD));
        BreathingPattern base = Breathing.patternOf(settings);
        TimeWarpedPattern warped = new TimeWarpedPattern(base, clock, 0);
        state = new State(base, warped, warped);
    }

    /** Holds or releases the breath. */
    public void hold(boolean held, double nowS) {
        clock.setRunning(!held, nowS, Ramp.DEFAULT_S);
    }

    /**
     * Changes to another pattern. Of two changes at one step only the second applies.
     *
     * @param next the new pattern
     * @param anew whether it starts from its beginning instead of continuing at the current phase
     */
    public void change(BreathingPattern next, boolean anew, long step, double nowS) {
        State from = step == changedAtStep ? previous : state;
        double intoS = anew ? 0 : matchPlace(from.base, next, from.warped.patternTimeS(nowS));
        TimeWarpedPattern warped = new TimeWarpedPattern(next, clock, clock.warpedTime(nowS) - intoS);
        previous = from;
        changedAtStep = step;
        boolean begins = anew && endBreath(from, nowS);
        state = new State(next, warped, BlendedPattern.crossfade(from.pattern, warped, nowS, Ramp.DEFAULT_S, begins));
    }

    /** Notes where a breath is cut short; returns whether there is one that another pattern ends. */
    private boolean endBreath(State from, double nowS) {
        BreathState breath = new BreathState();
        // The pattern itself: of a breath that is held, the phase in which it is held.
        from.base.at(from.warped.patternTimeS(nowS), breath);
        // What a second change at one step, or a return to an earlier state, has replaced does not count.
        cutShortS.removeIf(timeS -> timeS >= nowS);
        boolean over = breath.respiratoryPhase == RespiratoryPhase.PAUSE;
        boolean justBegun = !over && breath.phase < SAME_PHASE;
        if (!over && !justBegun && breath.phase < 1 - SAME_PHASE) {
            cutShortS.add(nowS);
        }
        return !justBegun;
    }

    /** Time in the next pattern at the same place: in the same breath, hold or apnoea as far as now. */
    private static double matchPlace(BreathingPattern base, BreathingPattern next, double intoS) {
        double[] from = base.stretchesS();
        double[] to = next.stretchesS();
        if (from.length != to.length || Arrays.equals(from, to)) {
            return intoS;
        }
        if (from.length == 1) {
            return intoS / from[0] * to[0];
        }
        boolean repeats = Double.isFinite(base.periodS()) && Double.isFinite(next.periodS());
        double rounds = repeats ? Math.floor(intoS / base.periodS()) : 0;
        double placeS = repeats ? intoS - rounds * base.periodS() : intoS;
        int i = 0;
        while (i < from.length - 1 && placeS >= from[i]) {
            i++;
        }
        double start = i == 0 ? 0 : from[i - 1];
        double startTo = i == 0 ? 0 : to[i - 1];
        double share = from[i] > start ? (placeS - start) / (from[i] - start) : 0;
        double within = share * (to[i] - startTo);
        return (repeats ? rounds * next.periodS() : 0) + startTo + within;
    }

    /** Times at which another pattern ended a breath whose expiration was not over, s; a copy. */
    public List<Double> cutShortS() {
        return List.copyOf(cutShortS);
    }

    /** Rate of the pattern's time: 1 while the breath goes on, 0 while it is held, between while it slows down. */
    public double rate(double nowS) {
        return clock.rate(nowS);
    }

    /** Time within the last pattern that was set, s. */
    public double patternTimeS(double nowS) {
        return state.warped.patternTimeS(nowS);
    }

    /** Period of the last pattern that was set, s; infinite if it is not periodic. */
    public double patternPeriodS() {
        return state.base.periodS();
    }

    /**
     * Duration of the shortest breath that ends between two times, with the breathing as it is, to {@value #SEARCH_S}
     * s; the time between them if none does.
     */
    public double shortestBreathS(double fromS, double toS) {
        BreathState breath = new BreathState();
        at(fromS, breath);
        int before = breath.breath;
        double begunS = fromS;
        double shortestS = toS - fromS;
        for (int i = 1; fromS + i * SEARCH_S <= toS + SAME_TIME_S; i++) {
            double timeS = fromS + i * SEARCH_S;
            at(timeS + SAME_TIME_S, breath);
            if (breath.breath != before) {
                shortestS = Math.min(shortestS, timeS - begunS);
                begunS = timeS;
                before = breath.breath;
            }
        }
        return shortestS;
    }

    @Override
    public double periodS() {
        return state.pattern.periodS();
    }

    /** That of the last pattern that was set. */
    @Override
    public double fullDurationS() {
        return state.base.fullDurationS();
    }

    @Override
    public void at(double timeS, BreathState breath) {
        state.pattern.at(timeS, breath);
    }
}
