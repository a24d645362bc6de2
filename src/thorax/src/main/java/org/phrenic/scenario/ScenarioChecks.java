package org.phrenic.scenario;

import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;

/** Checks that involve several settings of a scenario. */
final class ScenarioChecks {
    private ScenarioChecks() {}

    /**
     * Refuses settings that the material does not use, a duration shorter than a step, and invalid scheduled changes.
     *
     * @param given settings whose values are new
     * @param bad creates the exception for a setting and a message
     * @return the scenario
     */
    static Scenario require(
            Scenario scenario, Set<Setting<?>> given, BiFunction<Setting<?>, String, BadInputException> bad) {
        String material = scenario.material().label();
        for (Setting<?> setting : Materials.ofSome()) {
            if (isStated(scenario, setting) && !scenario.material().uses(setting)) {
                String others = Materials.ALL.stream()
                        .filter(m -> m.uses(setting))
                        .map(TissueMaterial::label)
                        .collect(Collectors.joining(" or "));
                throw given.contains(setting)
                        ? bad.apply(
                                setting,
                                "found it with material " + material
                                        + ", which does not use it; expected it with material " + others)
                        : bad.apply(
                                Materials.MATERIAL,
                                "found " + material + ", expected " + others + " beside the key '" + setting.key()
                                        + "' of the scenario");
            }
        }
        if (scenario.durationS() < scenario.timeStepS()) {
            throw bad.apply(
                    given.contains(RunSettings.DURATION) ? RunSettings.DURATION : Numerics.TIME_STEP,
                    "found a duration of " + scenario.durationS() + " s with a step of " + scenario.timeStepS()
                            + " s, expected at least one step");
        }
        return requireValidChanges(scenario);
    }

    /**
     * Whether a scenario states a setting. One that is no parameter and is stated at its default changes nothing; a
     * scenario that a run writes states it with every material.
     */
    private static boolean isStated(Scenario scenario, Setting<?> setting) {
        return scenario.states(setting)
                && (setting instanceof Parameter || !scenario.get(setting).equals(scenario.defaultOf(setting)));
    }

    /** Checks that every scheduled change is valid after those before it. */
    static Scenario requireValidChanges(Scenario scenario) {
        Scenario now = scenario.without(RunSettings.CHANGES);
        long before = 0;
        for (ScheduledChange change : scenario.changes()) {
            if (change.step() < before) {
                throw new BadInputException(change.assignment().origin() + ": found step " + change.step()
                        + " after step " + before + ", expected changes in the order of their steps");
            }
            before = change.step();
            change.assignment().requireLive();
            now = now.changed(List.of(change.assignment()));
        }
        return scenario;
    }
}
