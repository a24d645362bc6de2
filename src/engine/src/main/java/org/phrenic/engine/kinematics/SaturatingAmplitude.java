package org.phrenic.engine.kinematics;

/**
 * How far the ribs have turned when a share of the inspiratory capacity is in: much at first, little at the end.
 *
 * <p>{@code s(V) = (1 - exp(-V / c)) / (1 - exp(-1 / c))}, {@code V} the inspired volume over the inspiratory capacity;
 * {@code s(0) = 0}, {@code s(1) = 1}. Below 0 (below the resting volume) it goes on as the straight line of its slope
 * at 0, so that value and slope are continuous. That ribs move much less above the middle of the capacity than below it
 * was measured by B. Beyer et al. 2016 (Respir. Physiol. Neurobiol. 232:57); the exponential and {@code c = 0.5} are
 * ours.
 *
 * @param constant c, a share of the capacity, above 0
 */
public record SaturatingAmplitude(double constant) {

    /** {@code c = 0.5}: 73 % of the turn at half of the capacity. */
    public static final SaturatingAmplitude DEFAULT = new SaturatingAmplitude(0.5);

    public SaturatingAmplitude {
        if (!(constant > 0) || Double.isInfinite(constant)) {
            throw new IllegalArgumentException(
                    "saturating amplitude: constant " + constant + ", expected a number above 0");
        }
    }

    /** Share of the full turn at a share of the inspiratory capacity. */
    public double at(double volume) {
        double scale = -StrictMath.expm1(-1 / constant);
        return volume < 0 ? volume / (constant * scale) : -StrictMath.expm1(-volume / constant) / scale;
    }

    /**
     * Share of the inspiratory capacity at which the ribs have turned by a share: the inverse of {@link #at}.
     *
     * @param turn share of the full turn, at most 1
     * @throws IllegalArgumentException if it is above 1 or not a number
     */
    public double volume(double turn) {
        if (!(turn <= 1)) {
            throw new IllegalArgumentException("saturating amplitude: turn " + turn + ", expected at most 1");
        }
        double scale = -StrictMath.expm1(-1 / constant);
        return turn < 0 ? turn * constant * scale : -constant * StrictMath.log1p(-turn * scale);
    }

    /** {@code ds/dV}. */
    public double slope(double volume) {
        double atRest = 1 / (-StrictMath.expm1(-1 / constant) * constant);
        return volume < 0 ? atRest : atRest * StrictMath.exp(-volume / constant);
    }
}
