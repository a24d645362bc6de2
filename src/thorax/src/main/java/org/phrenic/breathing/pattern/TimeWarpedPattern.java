package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.TimeWarp;

/**
 * A pattern at warped time: its values at time t are those at tau(t), its rates are those at tau(t) times tau'(t).
 *
 * @param pattern function of warped time
 * @param clock time warp tau
 * @param originS warped time at which the pattern begins, s
 */
public record TimeWarpedPattern(BreathingPattern pattern, TimeWarp clock, double originS) implements BreathingPattern {
    @Override
    public double periodS() {
        return pattern.periodS();
    }

    @Override
    public double fullDurationS() {
        return pattern.fullDurationS();
    }

    /** Time within the pattern at a simulated time, s. */
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
