package org.phrenic.scenario;

import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;

/** Checks that involve several settings of a scenario. */
final class ScenarioChecks {
    private ScenarioChecks() {}

    /**
     * Refuses parameters that the material does not use, a duration shorter than a step, and invalid scheduled changes.
     *
     * @param given settings whose values are new
     * @param bad creates the exception for a setting and a message
     * @return the scenario
     */
    static Scenario require(
            Scenario scenario, Set<Setting<?>> given, BiFunction<Setting<?>, String, BadInputException> bad) {
        String material = scenario.material().label();
        for (Parameter parameter : Materials.parameters()) {
            if (scenario.states(parameter) && !scenario.material().uses(parameter)) {
                String other = Materials.ALL.stream()
                        .filter(m -> m.uses(parameter))
                        .findFirst()
                        .orElseThrow()
                        .label();
                throw given.contains(parameter)
                        ? bad.apply(
                                parameter,
                                "found it with material " + material
                                        + ", which does not use it; expected it with material " + other + " alone")
                        : bad.apply(
                                Materials.MATERIAL,
                                "found " + material + ", expected " + other + " beside the key '" + parameter.key()
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
            now = now.with(List.of(change.assignment()));
        }
        return scenario;
    }
}
