package org.phrenic.scenario;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.parameter.Setting;

/** Stated values that say no more than which material was there: a scenario that a run writes states every default. */
final class MaterialDefaults {
    private MaterialDefaults() {}

    /** As {@link #leftBy(Scenario, TissueMaterial)} for the materials among values that are assigned to a scenario. */
    static Set<Setting<?>> leftBy(Scenario scenario, List<Assignment> assignments) {
        return assignments.stream()
                .filter(assignment -> assignment.setting() == Materials.MATERIAL)
                .flatMap(assignment -> leftBy(scenario, (TissueMaterial) assignment.value()).stream())
                .collect(Collectors.toSet());
    }

    /** Settings that a scenario states at the default of its material where another has another default. */
    static Set<Setting<?>> leftBy(Scenario scenario, TissueMaterial other) {
        List<Setting<?>> stated =
                Settings.all().stream().filter(scenario::states).toList();
        if (stated.isEmpty()) {
            return Set.of();
        }
        Scenario now = Scenario.defaults().withMaterial(scenario.material());
        Scenario then = Scenario.defaults().withMaterial(other);
        return stated.stream()
                .filter(setting -> !now.defaultOf(setting).equals(then.defaultOf(setting)))
                .filter(setting -> scenario.get(setting).equals(scenario.defaultOf(setting)))
                .collect(Collectors.toSet());
    }
}
