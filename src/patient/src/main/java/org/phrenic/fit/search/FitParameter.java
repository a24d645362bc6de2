package org.phrenic.fit.search;

import java.util.List;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Lungs;
import org.phrenic.model.material.Mediastinum;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.parameter.FitRange;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/**
 * A parameter to fit, with bounds. The search uses a coordinate from 0 to 1 between the bounds. The coordinate is
 * logarithmic if the bounds are far apart.
 *
 * @param start initial value of the search
 */
public record FitParameter(Parameter parameter, double minimum, double maximum, double start) {
    /** The coordinate is logarithmic if the ratio of the bounds is at least this value. */
    private static final double WIDE = 4;

    public FitParameter {
        if (!(minimum < maximum) || !(start >= minimum && start <= maximum)) {
            throw new IllegalArgumentException(parameter.key() + ": found bounds " + minimum + " to " + maximum
                    + " about " + start + ", expected a least, a greatest value and one between them");
        }
        parameter.requireInRange(minimum);
        parameter.requireInRange(maximum);
    }

    /**
     * Returns a parameter with its default bounds. The search starts at its value in a scenario.
     *
     * @throws BadInputException if the held breath does not use the parameter
     */
    public static FitParameter of(Parameter parameter, Scenario scenario) {
        double start = scenario.get(parameter);
        if (!isUsed(parameter, scenario)) {
            throw new BadInputException("--tune " + parameter.key()
                    + ": found a parameter that the breath which is held does not use, expected another");
        }
        FitRange usual = parameter.fitRange();
        return new FitParameter(parameter, Math.min(usual.minimum(), start), Math.max(usual.maximum(), start), start);
    }

    /**
     * Parses {@code key} or {@code key=min:max}.
     *
     * @throws BadInputException if the text is invalid
     */
    public static FitParameter parse(String text, Scenario scenario) {
        int equals = text.indexOf('=');
        try {
            Parameter parameter = Settings.parameter(equals < 0 ? text : text.substring(0, equals));
            FitParameter usual = of(parameter, scenario);
            if (equals < 0) {
                return usual;
            }
            String[] bounds = text.substring(equals + 1).split(":", -1);
            if (bounds.length != 2) {
                throw new IllegalArgumentException("found '" + text + "', expected KEY or KEY=MIN:MAX");
            }
            double least = Numbers.parse(bounds[0]).orElseThrow(NumberFormatException::new);
            double most = Numbers.parse(bounds[1]).orElseThrow(NumberFormatException::new);
            return new FitParameter(parameter, least, most, Math.max(least, Math.min(most, usual.start)));
        } catch (NumberFormatException none) {
            throw new BadInputException("--tune " + text + ": found no number, expected KEY=MIN:MAX", none);
        } catch (BadInputException told) {
            throw told;
        } catch (IllegalArgumentException bad) {
            throw new BadInputException("--tune " + text + ": " + bad.getMessage(), bad);
        }
    }

    private static boolean isUsed(Parameter parameter, Scenario scenario) {
        return !Double.isNaN(scenario.get(parameter))
                && parameter != Breathing.RATE
                && parameter != Breathing.INSPIRATORY_FRACTION;
    }

    /**
     * Default parameters: drives of muscle, pressure and ribs, their distribution, and stiffness.
     *
     * @throws BadInputException if the held breath does not use one of them
     */
    public static List<FitParameter> defaults(Scenario scenario) {
        return Stream.of(
                        Muscle.MUSCLE_ACTIVATION,
                        Muscle.LEFT_OVER_RIGHT,
                        Muscle.FRONT_OVER_BACK,
                        TransdiaphragmaticPressure.GREATEST_PRESSURE,
                        TransdiaphragmaticPressure.PRESSURE_LEFT_OVER_RIGHT,
                        TransdiaphragmaticPressure.REST_PRESSURE,
                        RibRotation.RIB_ROTATION,
                        RibRotation.UPPER_RIB_ROTATION,
                        RibRotation.LOWER_RIB_ROTATION,
                        RibRotation.RIB_LEFT_OVER_RIGHT,
                        RibRotation.BUCKET_HANDLE,
                        SheetSprings.MUSCLE_STIFFNESS,
                        Lungs.LUNG_STIFFNESS,
                        Mediastinum.MEDIASTINUM_RIGHT,
                        Mediastinum.MEDIASTINUM_LEFT)
                .map(p -> usual(p, scenario))
                .toList();
    }

    private static FitParameter usual(Parameter parameter, Scenario scenario) {
        if (!isUsed(parameter, scenario)) {
            throw new BadInputException("fit: found a scenario whose breath does not use " + parameter.key()
                    + ", one of the parameters that a fit tunes by itself, expected --tune KEY,... with others");
        }
        return of(parameter, scenario);
    }

    /**
     * Initial standard deviation relative to other parameters. The main drives are searched more widely than parameters
     * that only modify them. A wide scatter of the latter would dominate the first generations.
     */
    public double relativeSigma() {
        return parameter.fitRange().spread();
    }

    private boolean isLogarithmic() {
        return minimum > 0 && maximum / minimum >= WIDE;
    }

    /** Converts a coordinate from 0 to 1 to a value. */
    public double fromUnit(double unit) {
        double u = Math.max(0, Math.min(1, unit));
        double value = isLogarithmic()
                ? minimum * StrictMath.exp(u * StrictMath.log(maximum / minimum))
                : minimum + u * (maximum - minimum);
        return Math.max(minimum, Math.min(maximum, value));
    }

    /** Converts a value to a coordinate from 0 to 1. */
    public double toUnit(double value) {
        return isLogarithmic()
                ? StrictMath.log(value / minimum) / StrictMath.log(maximum / minimum)
                : (value - minimum) / (maximum - minimum);
    }
}
