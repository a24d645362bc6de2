package org.phrenic.engine.kinematics;

/**
 * Rotation of the ribs as a saturating function of inspired volume: steep at first, flat near full inspiration.
 *
 * <p>{@code s(V) = (1 - exp(-V / c)) / (1 - exp(-1 / c))}, where {@code V} is the inspired volume divided by the
 * inspiratory capacity; {@code s(0) = 0}, {@code s(1) = 1}. Below 0 (below the resting volume) it continues linearly,
 * with continuous value and slope. B. Beyer et al. 2016 (Respir. Physiol. Neurobiol. 232:57) measured that ribs move
 * much less above half of the capacity than below it. The exponential form and {@code c = 0.5} are assumptions of this
 * project.
 *
 * @param constant c, relative to the capacity, above 0
 */
public record SaturatingAmplitude(double constant) {

    /** {@code c = 0.5}: 73 % of the rotation at half of the capacity. */
    public static final SaturatingAmplitude DEFAULT = new SaturatingAmplitude(0.5);

    public SaturatingAmplitude {
        if (!(constant > 0) || Double.isInfinite(constant)) {
            throw new IllegalArgumentException(
                    "saturating amplitude: constant " + constant + ", expected a number above 0");
        }
    }

    /** Fraction of the full rotation at a fraction of the inspiratory capacity. */
    public double at(double volume) {
        double scale = -StrictMath.expm1(-1 / constant);
        return volume < 0 ? volume / (constant * scale) : -StrictMath.expm1(-volume / constant) / scale;
    }

    /**
     * The inverse of {@link #at}: the fraction of the inspiratory capacity at a fraction of the rotation.
     *
     * @param turn fraction of the full rotation, at most 1
     * @throws IllegalArgumentException if it is above 1 or NaN
     */
    public double volume(double turn) {
        if (!(turn <= 1)) {
            throw new IllegalArgumentException("saturating amplitude: turn " + turn + ", expected at most 1");
        }
        double scale = -StrictMath.expm1(-1 / constant);
        return turn < 0 ? turn * constant * scale : -constant * StrictMath.log1p(-turn * scale);
    }

    /** The derivative {@code ds/dV}. */
    public double slope(double volume) {
        double atRest = 1 / (-StrictMath.expm1(-1 / constant) * constant);
        return volume < 0 ? atRest : atRest * StrictMath.exp(-volume / constant);
    }
}
