package org.phrenic.ui;

import java.util.Optional;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;

/** What a scenario has for a key, as rows show it and assignments take it. */
final class Settings {
    private Settings() {}

    /** Value of a parameter: the scenario's, its material's default or the breathing preset's; NaN if the material does not use it. */
    static double value(Scenario scenario, Parameter parameter) {
        double value = scenario.value(parameter);
        return Double.isNaN(value) && parameter.isFromPreset() ? ofPreset(scenario, parameter) : value;
    }

    /** Default of a parameter: the material's or the breathing preset's. */
    static double defaultOf(Scenario scenario, Parameter parameter) {
        return parameter.isFromPreset() ? ofPreset(scenario, parameter) : parameter.defaultFor(scenario.material());
    }

    private static double ofPreset(Scenario scenario, Parameter parameter) {
        BreathingParameters breathing = scenario.breathing().parameters();
        return switch (parameter) {
            case RATE -> breathing.ratePerMin();
            case INSPIRATORY_FRACTION -> breathing.inspiratoryFraction();
            case CHEST_SHARE -> breathing.chestShare();
            default -> Double.NaN;
        };
    }

    /** Value of a key as a scenario file has it; empty if the scenario leaves it open. */
    static Optional<String> text(Scenario scenario, String key) {
        if (Parameter.keys().contains(key)) {
            double value = value(scenario, Parameter.of(key));
            return Double.isNaN(value) ? Optional.empty() : Optional.of(plain(value));
        }
        return Optional.ofNullable(scenario.toMap().get(key)).map(Object::toString);
    }

    /** A parameter's new value. */
    static Assignment assignment(Parameter parameter, double value) {
        return new Assignment("window", parameter.key(), plain(value));
    }

    /** {@code Muscle stiffness 300 -> 450 N/m}. */
    static String changeName(String label, double from, double to, String unit) {
        return label + " " + Figures.text(from) + " -> " + Figures.withUnit(to, unit);
    }

    /** {@code Resolution medium -> low}. */
    static String changeName(String label, String from, String to) {
        return label + " " + from + " -> " + to;
    }

    /** As many digits as it takes, without a fraction where there is none: 300, 0.64. */
    static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
