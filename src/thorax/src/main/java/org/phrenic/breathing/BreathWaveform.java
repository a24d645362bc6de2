package org.phrenic.breathing;

/**
 * The shape of one breath over its phase: 0 at end-expiration, 1 at end-inspiration.
 *
 * <p>Inspiration is a smooth step. Expiration is passive: the same step, run through {@code w(u) = (1 - exp(-k u)) / (1
 * - exp(-k))}, {@code k = } {@value #EXPIRATION_RATE}, so that flow peaks early and ebbs away as from an emptying lung.
 * The pause that follows is exactly 0.
 *
 * @param inspiratoryFraction Ti / Ttot, between 0 and 1
 * @param pauseFraction share of the breath at rest at its end, from 0; with the inspiratory fraction below 1
 */
public record BreathWaveform(double inspiratoryFraction, double pauseFraction) {
    private static final double EXPIRATION_RATE = 1.5;
    private static final double PASSIVE_SCALE = -StrictMath.expm1(-EXPIRATION_RATE);

    public BreathWaveform {
        if (!(inspiratoryFraction > 0) || !(pauseFraction >= 0) || !(inspiratoryFraction + pauseFraction < 1)) {
            throw new IllegalArgumentException("breath: inspiratory fraction " + inspiratoryFraction
                    + " and pause fraction " + pauseFraction
                    + ", expected an inspiratory fraction above 0, a pause fraction from 0, and a sum below 1");
        }
    }

    /** Share of the breath taken by expiration. */
    public double expiratoryFraction() {
        return 1 - inspiratoryFraction - pauseFraction;
    }

    /** Value at a phase from 0 to 1. */
    public double value(double phase) {
        if (phase < inspiratoryFraction) {
            return Smootherstep.value(phase / inspiratoryFraction);
        }
        return 1 - Smootherstep.value(passiveWarp((phase - inspiratoryFraction) / expiratoryFraction()));
    }

    /** Derivative by the phase. */
    public double slope(double phase) {
        if (phase < inspiratoryFraction) {
            return Smootherstep.slope(phase / inspiratoryFraction) / inspiratoryFraction;
        }
        double u = (phase - inspiratoryFraction) / expiratoryFraction();
        if (u >= 1) {
            return 0;
        }
        double warpSlope = EXPIRATION_RATE * StrictMath.exp(-EXPIRATION_RATE * u) / PASSIVE_SCALE;
        return -Smootherstep.slope(passiveWarp(u)) * warpSlope / expiratoryFraction();
    }

    /** What the breath is doing at a phase. */
    public RespiratoryPhase respiratoryPhase(double phase) {
        if (phase < inspiratoryFraction) {
            return RespiratoryPhase.INSPIRATION;
        }
        return phase < inspiratoryFraction + expiratoryFraction()
                ? RespiratoryPhase.EXPIRATION
                : RespiratoryPhase.PAUSE;
    }

    private static double passiveWarp(double u) {
        return u >= 1 ? 1 : -StrictMath.expm1(-EXPIRATION_RATE * u) / PASSIVE_SCALE;
    }
}
