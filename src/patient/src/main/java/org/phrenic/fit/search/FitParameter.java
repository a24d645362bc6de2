package org.phrenic.fit.search;

import java.util.List;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;

/**
 * A number that a fit may tune, and how far. The search sees it as a place from 0 to 1 between its bounds, by its
 * logarithm where the bounds are far apart.
 *
 * @param parameter which
 * @param minimum least value
 * @param maximum greatest value
 * @param start where the search begins
 */
public record FitParameter(Parameter parameter, double minimum, double maximum, double start) {
    /** Bounds farther apart than by this factor are searched by the logarithm. */
    private static final double WIDE = 4;
    /** Of those that only bend what the three main ones do. */
    private static final double NARROW = 0.4;

    public FitParameter {
        if (!(minimum < maximum) || !(start >= minimum && start <= maximum)) {
            throw new IllegalArgumentException(parameter.key() + ": found bounds " + minimum + " to " + maximum
                    + " about " + start + ", expected a least, a greatest value and one between them");
        }
        parameter.requireInRange(minimum);
        parameter.requireInRange(maximum);
    }

    /**
     * A parameter with its usual bounds, beginning at its value in a scenario.
     *
     * @throws BadInputException if the scenario does not use it, or it says how fast is breathed
     */
    public static FitParameter of(Parameter parameter, Scenario scenario) {
        double start = parameter == Parameter.CHEST_SHARE && !scenario.states(parameter)
                ? scenario.breathing().parameters().chestShare()
                : scenario.value(parameter);
        if (Double.isNaN(start) || parameter == Parameter.RATE || parameter == Parameter.INSPIRATORY_FRACTION) {
            throw new BadInputException("--tune " + parameter.key()
                    + ": found a parameter that the breath which is held does not use, expected another");
        }
        double[] usual = defaultBounds(parameter);
        return new FitParameter(parameter, Math.min(usual[0], start), Math.max(usual[1], start), start);
    }

    /**
     * Reads {@code key} or {@code key=min:max}.
     *
     * @throws BadInputException with one sentence
     */
    public static FitParameter parse(String text, Scenario scenario) {
        int equals = text.indexOf('=');
        try {
            Parameter parameter = Parameter.named(equals < 0 ? text : text.substring(0, equals));
            FitParameter usual = of(parameter, scenario);
            if (equals < 0) {
                return usual;
            }
            String[] bounds = text.substring(equals + 1).split(":", -1);
            if (bounds.length != 2) {
                throw new IllegalArgumentException("found '" + text + "', expected KEY or KEY=MIN:MAX");
            }
            double least = Double.parseDouble(bounds[0]);
            double most = Double.parseDouble(bounds[1]);
            return new FitParameter(parameter, least, most, Math.max(least, Math.min(most, usual.start)));
        } catch (NumberFormatException none) {
            throw new BadInputException("--tune " + text + ": found no number, expected KEY=MIN:MAX", none);
        } catch (BadInputException told) {
            throw told;
        } catch (IllegalArgumentException bad) {
            throw new BadInputException("--tune " + text + ": " + bad.getMessage(), bad);
        }
    }

    /**
     * What is tuned where nothing else is said, with usual bounds: drives of muscle, pressure and ribs, their balance
     * by side, group and place, and stiffness.
     */
    public static List<FitParameter> defaults(Scenario scenario) {
        return Stream.of(
                        Parameter.MUSCLE_ACTIVATION,
                        Parameter.LEFT_OVER_RIGHT,
                        Parameter.FRONT_OVER_BACK,
                        Parameter.GREATEST_PRESSURE,
                        Parameter.PRESSURE_LEFT_OVER_RIGHT,
                        Parameter.REST_PRESSURE,
                        Parameter.RIB_ROTATION,
                        Parameter.UPPER_RIB_ROTATION,
                        Parameter.LOWER_RIB_ROTATION,
                        Parameter.RIB_LEFT_OVER_RIGHT,
                        Parameter.BUCKET_HANDLE,
                        Parameter.MUSCLE_STIFFNESS,
                        Parameter.LUNG_STIFFNESS,
                        Parameter.MEDIASTINUM_RIGHT,
                        Parameter.MEDIASTINUM_LEFT)
                .map(p -> of(p, scenario))
                .toList();
    }

    /** Narrower than what a scenario may ask for where that would cost substeps or mean nothing in a person. */
    private static double[] defaultBounds(Parameter parameter) {
        return switch (parameter) {
            case MUSCLE_ACTIVATION -> new double[] {0.1, 0.8};
            case LEFT_OVER_RIGHT -> new double[] {0.5, 2};
            case GREATEST_PRESSURE -> new double[] {0, 8};
            case REST_PRESSURE -> new double[] {0.05, 1};
            case FRONT_OVER_BACK, PRESSURE_LEFT_OVER_RIGHT -> new double[] {0.4, 2.5};
            case CHEST_SHARE -> new double[] {0.3, 0.7};
            case UPPER_RIB_ROTATION, LOWER_RIB_ROTATION -> new double[] {0.3, 1.7};
            case RIB_LEFT_OVER_RIGHT -> new double[] {0.6, 1.6};
            case BUCKET_HANDLE -> new double[] {0, 2};
            case MEDIASTINUM_RIGHT, MEDIASTINUM_LEFT -> new double[] {0, 40};
            case MUSCLE_STIFFNESS -> new double[] {100, 450};
            case TENDON_RATIO -> new double[] {2, 20};
            case LUNG_STIFFNESS -> new double[] {1, 20};
            case STERNUM_COUPLING -> new double[] {0.3, 3};
            default -> new double[] {parameter.minimum(), parameter.maximum()};
        };
    }

    /**
     * How widely it is searched at first beside others: what says how far muscle and ribs go on the whole is looked for
     * widely, what only bends that less so, or its scatter would drown the rest in the first generations.
     */
    public double relativeSigma() {
        return switch (parameter) {
            case MUSCLE_ACTIVATION, LEFT_OVER_RIGHT, RIB_ROTATION -> 1;
            default -> NARROW;
        };
    }

    private boolean isLogarithmic() {
        return minimum > 0 && maximum / minimum >= WIDE;
    }

    /** The value at a place from 0 to 1 between the bounds. */
    public double fromUnit(double unit) {
        double u = Math.max(0, Math.min(1, unit));
        double value = isLogarithmic()
                ? minimum * StrictMath.exp(u * StrictMath.log(maximum / minimum))
                : minimum + u * (maximum - minimum);
        return Math.max(minimum, Math.min(maximum, value));
    }

    /** The place of a value between the bounds, 0 to 1. */
    public double toUnit(double value) {
        return isLogarithmic()
                ? StrictMath.log(value / minimum) / StrictMath.log(maximum / minimum)
                : (value - minimum) / (maximum - minimum);
    }
}
