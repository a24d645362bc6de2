package org.phrenic.simulation;

import org.phrenic.breathing.BlendedPattern;
import org.phrenic.breathing.BreathClock;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.WarpedPattern;

/**
 * The breathing pattern of a run, which changes while it runs: another preset begins anew, another rate, depth or balance goes on at the same place of the pattern, and the whole can be held. A function of
 * the time and of the changes made.
 */
final class LiveBreath implements BreathingPattern {
    private final BreathClock clock;
    private BreathingPattern base;
    private WarpedPattern leaf;
    private BreathingPattern pattern;
    private BreathingPattern baseBefore;
    private WarpedPattern leafBefore;
    private BreathingPattern before;
    private long changed = -1;

    LiveBreath(Scenario scenario) {
        clock = new BreathClock(!scenario.hold());
        base = Patterns.of(scenario);
        leaf = new WarpedPattern(base, clock, 0);
        pattern = leaf;
    }

    /** Holds the breath where it is, or lets it go on. */
    void hold(boolean held, double nowS) {
        clock.turn(!held, nowS, Ramp.DEFAULT_S);
    }

    /**
     * Goes over to another pattern; of two changes at one step the first is as if it had not been.
     *
     * @param next its pattern
     * @param anew whether it begins with a breath of its own, or goes on where the breath is
     */
    void change(BreathingPattern next, boolean anew, long step, double nowS) {
        if (step == changed) {
            base = baseBefore;
            leaf = leafBefore;
            pattern = before;
        }
        double intoS = anew ? 0 : place(next, leaf.intoS(nowS));
        WarpedPattern nextLeaf = new WarpedPattern(next, clock, clock.tau(nowS) - intoS);
        baseBefore = base;
        leafBefore = leaf;
        before = pattern;
        changed = step;
        pattern = BlendedPattern.over(pattern, nextLeaf, nowS, Ramp.DEFAULT_S, anew);
        base = next;
        leaf = nextLeaf;
    }

    /** The same share of the period; the same time from the beginning where one of the two does not repeat itself. */
    private double place(BreathingPattern next, double intoS) {
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
    public double wholeS() {
        return pattern.wholeS();
    }

    @Override
    public void at(double timeS, BreathState state) {
        pattern.at(timeS, state);
    }
}
