package org.phrenic.fit.search;

import java.util.List;
import java.util.Map;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.parameter.Parameter;

/**
 * The unit cube that is searched, and the mapping from its points to parameter values within their bounds
 * ({@link FitParameter}). A scenario defines a drive for the stronger side and a ratio for the other side. The effect
 * of the ratio therefore has a kink where both sides are equal. To avoid it, if both are fitted, the coordinate u of a
 * drive represents the geometric mean of the sides: {@code value = fromUnit(u) prod sqrt(max(q, 1/q))} over its ratios
 * q, limited to the bounds.
 */
public record SearchSpace(List<FitParameter> parameters) {
    /** Ratios that distribute each drive. */
    private static final Map<Parameter, List<Parameter>> SHARED = Map.of(
            Muscle.MUSCLE_ACTIVATION, List.of(Muscle.LEFT_OVER_RIGHT, Muscle.FRONT_OVER_BACK),
            TransdiaphragmaticPressure.GREATEST_PRESSURE, List.of(TransdiaphragmaticPressure.PRESSURE_LEFT_OVER_RIGHT),
            RibRotation.RIB_ROTATION, List.of(RibRotation.RIB_LEFT_OVER_RIGHT));

    /** A coordinate nearer to 0 or 1 than this is at a bound. */
    private static final double AT_BOUND = 1e-6;

    public SearchSpace {
        parameters = List.copyOf(parameters);
    }

    /** Start point of the search. */
    double[] startPoint() {
        double[] values = parameters.stream().mapToDouble(FitParameter::start).toArray();
        double[] unit = new double[values.length];
        for (int i = 0; i < unit.length; i++) {
            FitParameter p = parameters.get(i);
            unit[i] = p.toUnit(Math.max(p.minimum(), meanOfSides(i, values)));
        }
        return unit;
    }

    /**
     * The way in the cube that moves one value alone. Where a ratio moves, the coordinate of its drive moves too, so
     * that the drive of the stronger side stays.
     *
     * @param values values of the parameters
     * @param parameter index of the parameter
     * @param to its other value
     * @return change of each coordinate
     */
    public double[] wayOf(double[] values, int parameter, double to) {
        double[] moved = values.clone();
        moved[parameter] = to;
        double[] way = new double[values.length];
        for (int i = 0; i < way.length; i++) {
            FitParameter p = parameters.get(i);
            way[i] = p.toUnit(meanOfSides(i, moved)) - p.toUnit(meanOfSides(i, values));
        }
        return way;
    }

    /**
     * The point with less drive: activation, pressure and rib rotation are multiplied by a factor, within their bounds.
     * All other coordinates are unchanged.
     *
     * @param factor from 0 to 1
     */
    double[] withDrive(double[] unit, double factor) {
        double[] less = unit.clone();
        for (int i = 0; i < less.length; i++) {
            FitParameter p = parameters.get(i);
            if (SHARED.containsKey(p.parameter()) && factor < 1) {
                less[i] = p.toUnit(Math.max(p.minimum(), factor * p.fromUnit(unit[i])));
            }
        }
        return less;
    }

    /** Parameter values at a point of the cube. */
    public double[] values(double[] unit) {
        double[] values = new double[unit.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = parameters.get(i).fromUnit(unit[i]);
        }
        double[] shared = values.clone();
        for (int i = 0; i < values.length; i++) {
            FitParameter p = parameters.get(i);
            shared[i] = Math.min(p.maximum(), values[i] * strongerSideOverMean(p, values));
        }
        return shared;
    }

    /**
     * Whether a value is at a bound, or nearer than a millionth of the range. Of a drive whose sides differ the mean
     * may be there while the value, that of the stronger side, is not.
     */
    public boolean isAtBound(double[] values, int parameter) {
        FitParameter p = parameters.get(parameter);
        double value = p.toUnit(values[parameter]);
        double mean = p.toUnit(Math.max(p.minimum(), meanOfSides(parameter, values)));
        return Math.min(Math.min(value, 1 - value), mean) < AT_BOUND;
    }

    /** The value of a parameter, of a drive the geometric mean of its sides. */
    private double meanOfSides(int parameter, double[] values) {
        return values[parameter] / strongerSideOverMean(parameters.get(parameter), values);
    }

    /** Ratio of the stronger side to the geometric mean, over all fitted ratios of a drive; 1 if there are none. */
    private double strongerSideOverMean(FitParameter strength, double[] values) {
        double product = 1;
        for (Parameter ratio : SHARED.getOrDefault(strength.parameter(), List.of())) {
            for (int i = 0; i < values.length; i++) {
                if (parameters.get(i).parameter() == ratio) {
                    product *= Math.sqrt(Math.max(values[i], 1 / values[i]));
                }
            }
        }
        return product;
    }
}
