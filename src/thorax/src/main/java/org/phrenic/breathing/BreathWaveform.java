package org.phrenic.breathing;

/**
 * The waveform of one breath as a function of its phase: 0 at end-expiration, 1 at end-inspiration.
 *
 * <p>Inspiration is a smootherstep. Expiration is passive: the same step at the warped argument {@code w(u) = (1 -
 * exp(-k u)) / (1 - exp(-k))} with {@code k = } {@value #EXPIRATION_RATE}, so that flow peaks early and decays as from
 * a passively emptying lung. The value is exactly 0 during the pause that follows.
 *
 * @param inspiratoryFraction Ti / Ttot, between 0 and 1
 * @param pauseFraction fraction of the breath at rest at its end, at least 0; its sum with the inspiratory fraction is
 *     below 1
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

    /** Fraction of the breath taken by expiration. */
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

    /** Derivative with respect to phase. */
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

    /** Respiratory phase at a phase from 0 to 1. */
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
