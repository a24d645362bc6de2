package org.phrenic.breathing;

/** A pattern by the clock of a breath that can be held: asked for time t it gives what the pattern asks for at tau(t), its rates times tau'(t). */
public final class WarpedPattern implements BreathingPattern {
    private final BreathingPattern pattern;
    private final BreathClock clock;
    private final double originS;

    /**
     * @param pattern by the breath's own time
     * @param clock shows the breath's own time
     * @param originS what the clock shows where the pattern begins, s
     */
    public WarpedPattern(BreathingPattern pattern, BreathClock clock, double originS) {
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
    public double wholeS() {
        return pattern.wholeS();
    }

    /** How far into the pattern it is at a time, s. */
    public double intoS(double timeS) {
        return clock.tau(timeS) - originS;
    }

    @Override
    public void at(double timeS, BreathState state) {
        pattern.at(intoS(timeS), state);
        double rate = clock.rate(timeS);
        state.activationRate *= rate;
        state.ribTurnRate *= rate;
        if (rate == 0) {
            state.label = BreathLabel.HOLD;
        }
    }
}
