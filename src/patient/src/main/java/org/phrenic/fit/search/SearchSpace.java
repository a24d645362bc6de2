package org.phrenic.fit.search;

import java.util.List;
import java.util.Map;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.parameter.Parameter;

/**
 * The unit cube that is searched, and the values of the parameters at its places. Each parameter lies between its
 * bounds ({@link FitParameter}). A scenario gives a drive to the stronger side and a ratio to the other, so that its
 * effect has a kink where the sides are alike; here the strength goes with the geometric mean of the sides where both
 * are tuned: {@code value = at(u) prod sqrt(max(q, 1/q))} over its ratios q, within the bounds.
 */
public record SearchSpace(List<FitParameter> parameters) {
    /** Ratios that share out a strength. */
    private static final Map<Parameter, List<Parameter>> SHARED = Map.of(
            Muscle.MUSCLE_ACTIVATION, List.of(Muscle.LEFT_OVER_RIGHT, Muscle.FRONT_OVER_BACK),
            TransdiaphragmaticPressure.GREATEST_PRESSURE, List.of(TransdiaphragmaticPressure.PRESSURE_LEFT_OVER_RIGHT),
            RibRotation.RIB_ROTATION, List.of(RibRotation.RIB_LEFT_OVER_RIGHT));

    public SearchSpace {
        parameters = List.copyOf(parameters);
    }

    /** Where the search begins. */
    double[] startPoint() {
        double[] values = parameters.stream().mapToDouble(FitParameter::start).toArray();
        double[] unit = new double[values.length];
        for (int i = 0; i < unit.length; i++) {
            FitParameter p = parameters.get(i);
            unit[i] = p.toUnit(Math.max(p.minimum(), values[i] / strongerSideOverMean(p, values)));
        }
        return unit;
    }

    /** Values at a place of the cube. */
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
     * The stronger side over the geometric mean of both, of all ratios of a strength that are tuned; 1 of what has
     * none.
     */
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
