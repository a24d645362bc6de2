package org.phrenic.ui.session;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.organ.TendonRule;

/** What a scenario has for a key, as rows show it and assignments take it. */
public final class ScenarioValues {
    private ScenarioValues() {}

    /**
     * Value of a parameter: the scenario's, its material's default or the breathing preset's; NaN if the material does
     * not use it.
     */
    public static double value(Scenario scenario, Parameter parameter) {
        double value = scenario.value(parameter);
        return Double.isNaN(value) && parameter.isGivenByPreset() ? ofPreset(scenario, parameter) : value;
    }

    /** Default of a parameter: the material's or the breathing preset's. */
    public static double defaultOf(Scenario scenario, Parameter parameter) {
        return parameter.isGivenByPreset() ? ofPreset(scenario, parameter) : parameter.defaultFor(scenario.material());
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
            double value = value(scenario, Parameter.named(key));
            return Double.isNaN(value) ? Optional.empty() : Optional.of(plain(value));
        }
        return Optional.ofNullable(scenario.toMap().get(key)).map(Object::toString);
    }

    /**
     * The scenario of another material: what this one states stays, but for what the other does not use; pressure and
     * tendon are those that belong to it. The paper's sheet has no pressure and a tendon above a plane.
     */
    public static Scenario ofMaterial(Scenario scenario, TissueMaterial material) {
        boolean paper = material == TissueMaterial.PAPER;
        return restated(scenario, material, Set.of("material", "pressure", "tendon"))
                .with(List.of(
                        new Assignment("window", "material", material.label()),
                        new Assignment("window", "pressure", String.valueOf(!paper)),
                        new Assignment("window", "tendon", (paper ? TendonRule.PLANE : TendonRule.TREFOIL).label())))
                .with(stated(scenario, material));
    }

    /** The same scenario without its recorded trace: it breathes as its preset does. */
    public static Scenario withoutTrace(Scenario scenario) {
        return restated(scenario, scenario.material(), Set.of("trace")).with(stated(scenario, scenario.material()));
    }

    /**
     * Everything but the numbers of {@link Parameter} and some keys, said anew over the defaults: a key that is left
     * out is as it comes.
     */
    private static Scenario restated(Scenario scenario, TissueMaterial material, Set<String> without) {
        List<Assignment> list = new ArrayList<>();
        scenario.toMap().forEach((key, value) -> {
            boolean open = (key.equals("time_step_s") && Double.isNaN(scenario.givenTimeStepS()))
                    || (key.equals("name") && scenario.givenName() == null)
                    || key.equals("changes")
                    || key.equals("steps");
            if (!open && !without.contains(key) && !Parameter.keys().contains(key)) {
                list.add(new Assignment("window", key, value.toString()));
            }
        });
        if (!without.contains("material")) {
            list.add(new Assignment("window", "material", material.label()));
        }
        return Scenario.defaults().with(list);
    }

    /** The numbers that the scenario states and the material uses. */
    private static List<Assignment> stated(Scenario scenario, TissueMaterial material) {
        List<Assignment> list = new ArrayList<>();
        scenario.given().forEach((parameter, value) -> {
            if (parameter.isUsedBy(material)) {
                list.add(assignment(parameter, value));
            }
        });
        return list;
    }

    /**
     * What leads from one scenario to another while it breathes; empty if that takes another scene. Names do not count.
     */
    public static Optional<List<Assignment>> liveDifference(Scenario from, Scenario to) {
        Set<String> keys = new LinkedHashSet<>(to.toMap().keySet());
        keys.addAll(from.toMap().keySet());
        keys.addAll(Parameter.keys());
        keys.removeAll(Set.of("name", "steps", "changes"));
        List<Assignment> list = new ArrayList<>();
        for (String key : keys) {
            Optional<String> wanted = text(to, key);
            if (wanted.equals(text(from, key))) {
                continue;
            }
            if (wanted.isEmpty() || !Simulation.isLive(key)) {
                return Optional.empty();
            }
            list.add(new Assignment("window", key, wanted.get()));
        }
        return Optional.of(list);
    }

    /** A parameter's new value. */
    public static Assignment assignment(Parameter parameter, double value) {
        return new Assignment("window", parameter.key(), plain(value));
    }

    /** Values of a scenario for the keys of some assignments; empty if it has no value for one of them. */
    static Optional<List<Assignment>> valuesOf(Scenario scenario, List<Assignment> assignments) {
        List<Assignment> values = new ArrayList<>();
        for (Assignment assignment : assignments) {
            Optional<String> value = text(scenario, assignment.key());
            if (value.isEmpty()) {
                return Optional.empty();
            }
            values.add(new Assignment("undo", assignment.key(), value.get()));
        }
        return Optional.of(values);
    }

    /** As many digits as it takes, without a fraction where there is none: 300, 0.64. */
    public static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
