package org.phrenic.breathing;

import org.phrenic.document.Key;

/**
 * Parameters of a breath. The presets in {@code data/breathing} give a source for each number.
 *
 * @param ratePerMin breaths per minute, above 0, at most 150
 * @param inspiratoryFraction Ti / Ttot, above 0
 * @param pauseFraction fraction of the breath at rest at its end
 * @param activation activation of the diaphragm at end-inspiration, 0 to 1 (1: full inspiration)
 * @param pressure transdiaphragmatic pressure at end-inspiration as a fraction of the maximum voluntary one, 0 to 1
 * @param ribTurn rib rotation at end-inspiration as a fraction of the full rotation, 0 to 1
 * @param chestShare balance of chest and abdomen, 0 to 1: 0.5 leaves both drives unchanged, 0 breathes with the
 *     diaphragm alone, 1 with the ribs alone
 */
public record BreathingParameters(
        @Key(above = 0, max = 150) double ratePerMin,
        double inspiratoryFraction,
        double pauseFraction,
        @Key(min = 0, max = 1) double activation,
        @Key(min = 0, max = 1) double pressure,
        @Key(min = 0, max = 1) double ribTurn,
        @Key(min = 0, max = 1) double chestShare) {
    private static final double MAX_RATE_PER_MIN = 150;

    public BreathingParameters {
        if (!(ratePerMin > 0) || !(ratePerMin <= MAX_RATE_PER_MIN)) {
            throw new IllegalArgumentException(
                    "breathing: rate_per_min " + ratePerMin + ", expected more than 0, at most " + MAX_RATE_PER_MIN);
        }
        requireShare("activation", activation);
        requireShare("pressure", pressure);
        requireShare("rib_turn", ribTurn);
        requireShare("chest_share", chestShare);
        new BreathWaveform(inspiratoryFraction, pauseFraction);
    }

    public static void requireShare(String name, double value) {
        if (!(value >= 0) || !(value <= 1)) {
            throw new IllegalArgumentException("breathing: " + name + " " + value + ", expected 0 to 1");
        }
    }

    /** Duration of a breath, s. */
    public double periodS() {
        return 60 / ratePerMin;
    }

    /** Waveform of a breath. */
    public BreathWaveform wave() {
        return new BreathWaveform(inspiratoryFraction, pauseFraction);
    }

    /** Activation of the diaphragm at end-inspiration after balancing chest and abdomen; at most 1. */
    public double activationPeak() {
        return Math.min(1, 2 * (1 - chestShare) * activation);
    }

    /** Pressure at end-inspiration after balancing chest and abdomen; at most 1. */
    public double pressurePeak() {
        return Math.min(1, 2 * (1 - chestShare) * pressure);
    }

    /** Rib rotation at end-inspiration after balancing chest and abdomen; at most 1. */
    public double ribTurnPeak() {
        return Math.min(1, 2 * chestShare * ribTurn);
    }

    /** Returns a copy with another rate, breaths per minute. */
    public BreathingParameters withRatePerMin(double value) {
        return new BreathingParameters(
                value, inspiratoryFraction, pauseFraction, activation, pressure, ribTurn, chestShare);
    }

    /** Returns a copy with activation, pressure and rib rotation multiplied by a factor, each at most 1. */
    public BreathingParameters withDepth(double factor) {
        return new BreathingParameters(
                ratePerMin,
                inspiratoryFraction,
                pauseFraction,
                Math.min(1, factor * activation),
                Math.min(1, factor * pressure),
                Math.min(1, factor * ribTurn),
                chestShare);
    }

    /**
     * Returns a copy with rate, inspiratory fraction and balance changed in the proportion in which those of another
     * breath changed, rate and balance at most to their greatest values.
     *
     * @param before parameters of the other breath
     * @param after its parameters after the change
     */
    public BreathingParameters changedAs(BreathingParameters before, BreathingParameters after) {
        return withRatePerMin(Math.min(MAX_RATE_PER_MIN, inProportion(ratePerMin, before.ratePerMin, after.ratePerMin)))
                .withInspiratoryFraction(
                        inProportion(inspiratoryFraction, before.inspiratoryFraction, after.inspiratoryFraction))
                .withChestShare(Math.min(1, inProportion(chestShare, before.chestShare, after.chestShare)));
    }

    private static double inProportion(double value, double before, double after) {
        return before == after ? value : before > 0 ? value * (after / before) : after;
    }

    /** Returns a copy with another inspiratory fraction. */
    public BreathingParameters withInspiratoryFraction(double value) {
        return new BreathingParameters(ratePerMin, value, pauseFraction, activation, pressure, ribTurn, chestShare);
    }

    /** Returns a copy with another balance of chest and abdomen. */
    public BreathingParameters withChestShare(double value) {
        return new BreathingParameters(
                ratePerMin, inspiratoryFraction, pauseFraction, activation, pressure, ribTurn, value);
    }
}
