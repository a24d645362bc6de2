package org.phrenic.breathing.pattern;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * A smooth crossfade between two patterns, for changes of preset or parameter during a simulation.
 *
 * <p>During the ramp the values are {@code (1 - r) a + r b}, where {@code r} is the value of the ramp. The rates follow
 * by the product rule, so that values and derivatives are continuous. The breath count continues.
 */
public final class BlendedPattern implements BreathingPattern {
    private final BreathingPattern from;
    private final BreathingPattern to;
    private final Ramp ramp;
    private final int breathOffset;

    private BlendedPattern(BreathingPattern from, BreathingPattern to, Ramp ramp, int breathOffset) {
        this.from = from;
        this.to = to;
        this.ramp = ramp;
        this.breathOffset = breathOffset;
    }

    /**
     * Crossfades to another pattern; both are evaluated at the same time.
     *
     * @param from current pattern; its finished ramps are dropped
     * @param to next pattern; it starts from its state at {@code nowS}
     * @param nowS time of the change, s
     * @param rampS duration of the crossfade, s, above 0
     * @param newBreath true if a breath begins with the change, false if the current breath continues
     */
    public static BlendedPattern crossfade(
            BreathingPattern from, BreathingPattern to, double nowS, double rampS, boolean newBreath) {
        BreathState state = new BreathState();
        from.at(nowS, state);
        int before = state.breath + (newBreath ? 1 : 0);
        to.at(nowS, state);
        return new BlendedPattern(dropFinished(from, nowS), to, new Ramp(0, 1, nowS, rampS), before - state.breath);
    }

    /** Drops the first pattern of every finished blend, so that repeated changes do not build a chain. */
    private static BreathingPattern dropFinished(BreathingPattern pattern, double nowS) {
        if (!(pattern instanceof BlendedPattern blended) || blended.from == null) {
            return pattern;
        }
        BreathingPattern earlier = blended.ramp.isDone(nowS) ? null : dropFinished(blended.from, nowS);
        return new BlendedPattern(earlier, blended.to, blended.ramp, blended.breathOffset);
    }

    @Override
    public double periodS() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public void at(double timeS, BreathState state) {
        if (from != null && timeS < ramp.startS()) {
            from.at(timeS, state);
            return;
        }
        to.at(timeS, state);
        state.breath += breathOffset;
        if (from == null || ramp.isDone(timeS)) {
            return;
        }
        double activation = state.activation;
        double activationRate = state.activationRate;
        double pressure = state.pressure;
        double abdominalPressure = state.abdominalPressure;
        double ribTurn = state.ribTurn;
        double ribTurnRate = state.ribTurnRate;
        double phase = state.phase;
        int breath = state.breath;
        RespiratoryPhase label = state.respiratoryPhase;

        from.at(timeS, state);
        double r = ramp.at(timeS);
        double rate = ramp.rate(timeS);
        state.activationRate += r * (activationRate - state.activationRate) + rate * (activation - state.activation);
        state.activation += r * (activation - state.activation);
        state.ribTurnRate += r * (ribTurnRate - state.ribTurnRate) + rate * (ribTurn - state.ribTurn);
        state.ribTurn += r * (ribTurn - state.ribTurn);
        state.pressure += r * (pressure - state.pressure);
        state.abdominalPressure += r * (abdominalPressure - state.abdominalPressure);
        state.phase = phase;
        state.breath = breath;
        state.respiratoryPhase = label;
    }
}
