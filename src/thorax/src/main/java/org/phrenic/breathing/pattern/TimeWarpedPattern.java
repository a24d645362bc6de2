package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.TimeWarp;

/** A pattern evaluated at warped time: at time t its values are those at tau(t), its rates those times tau'(t). */
public final class TimeWarpedPattern implements BreathingPattern {
    private final BreathingPattern pattern;
    private final TimeWarp clock;
    private final double originS;

    /**
     * @param pattern by the breath's own time
     * @param clock shows the breath's own time
     * @param originS what the clock shows where the pattern begins, s
     */
    public TimeWarpedPattern(BreathingPattern pattern, TimeWarp clock, double originS) {
        this.pattern = pattern;
        this.clock = clock;
        this.originS = originS;
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

    /** How far into the pattern it is at a time, s. */
    public double patternTimeS(double timeS) {
        return clock.warpedTime(timeS) - originS;
    }

    @Override
    public void at(double timeS, BreathState state) {
        pattern.at(patternTimeS(timeS), state);
        double rate = clock.rate(timeS);
        state.activationRate *= rate;
        state.ribTurnRate *= rate;
        if (rate == 0) {
            state.respiratoryPhase = RespiratoryPhase.HOLD;
        }
    }
}
