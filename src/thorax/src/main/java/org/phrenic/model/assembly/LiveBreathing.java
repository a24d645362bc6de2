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
    private final TimeWarp clock;
    private BreathingPattern base;
    private TimeWarpedPattern warped;
    private BreathingPattern pattern;
    private BreathingPattern previousBase;
    private TimeWarpedPattern previousWarped;
    private BreathingPattern previous;
    private long changedAtStep = -1;

    public LiveBreathing(SettingValues settings) {
        clock = new TimeWarp(!settings.get(Breathing.HOLD));
        base = Breathing.patternOf(settings);
        warped = new TimeWarpedPattern(base, clock, 0);
        pattern = warped;
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
        if (step == changedAtStep) {
            base = previousBase;
            warped = previousWarped;
            pattern = previous;
        }
        double intoS = anew ? 0 : matchPhase(next, warped.patternTimeS(nowS));
        TimeWarpedPattern nextLeaf = new TimeWarpedPattern(next, clock, clock.warpedTime(nowS) - intoS);
        previousBase = base;
        previousWarped = warped;
        previous = pattern;
        changedAtStep = step;
        pattern = BlendedPattern.crossfade(pattern, nextLeaf, nowS, Ramp.DEFAULT_S, anew);
        base = next;
        warped = nextLeaf;
    }

    /**
     * Time in the next pattern at the same phase of the period. If one of the patterns is not periodic, the time since
     * the start is kept.
     */
    private double matchPhase(BreathingPattern next, double intoS) {
        double from = base.periodS();
        double to = next.periodS();
        return Double.isInfinite(from) || Double.isInfinite(to) || from == to ? intoS : intoS / from * to;
    }

    @Override
    public String name() {
        return pattern.name();
    }

    @Override
    public double periodS() {
        return pattern.periodS();
    }

    @Override
    public double fullDurationS() {
        return pattern.fullDurationS();
    }

    @Override
    public void at(double timeS, BreathState state) {
        pattern.at(timeS, state);
    }
}
