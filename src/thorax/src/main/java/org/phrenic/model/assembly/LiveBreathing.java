package org.phrenic.model.assembly;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.TimeWarp;
import org.phrenic.breathing.pattern.BlendedPattern;
import org.phrenic.breathing.pattern.TimeWarpedPattern;
import org.phrenic.parameter.SettingValues;

/**
 * The breathing pattern of a run, which changes while it runs: another preset begins anew, another rate, depth or
 * balance goes on at the same place of the pattern, and the whole can be held. A function of the time and of the
 * changes made.
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

    /** Holds the breath where it is, or lets it go on. */
    public void hold(boolean held, double nowS) {
        clock.setRunning(!held, nowS, Ramp.DEFAULT_S);
    }

    /**
     * Goes over to another pattern; of two changes at one step the first is as if it had not been.
     *
     * @param next its pattern
     * @param anew whether it begins with a breath of its own, or goes on where the breath is
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

    /** The same share of the period; the same time from the beginning where one of the two does not repeat itself. */
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
