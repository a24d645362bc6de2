package org.phrenic.model.assembly;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
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

    private final TimeWarp clock;
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
        double intoS = anew ? 0 : matchPhase(from.base, next, from.warped.patternTimeS(nowS));
        TimeWarpedPattern warped = new TimeWarpedPattern(next, clock, clock.warpedTime(nowS) - intoS);
        previous = from;
        changedAtStep = step;
        state = new State(next, warped, BlendedPattern.crossfade(from.pattern, warped, nowS, Ramp.DEFAULT_S, anew));
    }

    /**
     * Time in the next pattern at the same phase of the period. If one of the patterns is not periodic, the time since
     * the start is kept.
     */
    private static double matchPhase(BreathingPattern base, BreathingPattern next, double intoS) {
        double from = base.periodS();
        double to = next.periodS();
        return Double.isInfinite(from) || Double.isInfinite(to) || from == to ? intoS : intoS / from * to;
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

    @Override
    public String name() {
        return state.pattern.name();
    }

    @Override
    public double periodS() {
        return state.pattern.periodS();
    }

    @Override
    public double fullDurationS() {
        return state.pattern.fullDurationS();
    }

    @Override
    public void at(double timeS, BreathState breath) {
        state.pattern.at(timeS, breath);
    }
}
