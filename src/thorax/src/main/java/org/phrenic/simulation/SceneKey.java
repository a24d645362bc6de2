package org.phrenic.simulation;

import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.ComputedArrays;
import org.phrenic.file.Hashes;
import org.phrenic.file.UserCache;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/**
 * What an assembled and settled scene depends on: the body and all settings but those of the run's length and output.
 */
final class SceneKey {
    private static final String KIND = "scene";

    private static final List<Setting<?>> OF_THE_RUN = List.of(
            RunSettings.NAME,
            RunSettings.ANATOMY,
            RunSettings.DURATION,
            RunSettings.STEPS,
            RunSettings.RECORD_EVERY,
            RunSettings.MESHES_EVERY,
            RunSettings.CHANGES,
            Breathing.REPEAT,
            Numerics.THREADS);

    private SceneKey() {}

    /** The arrays of a scene that a cache holds. */
    static ComputedArrays arrays(UserCache cache, Scenario scenario, Thorax thorax) {
        return cache.isOff() ? ComputedArrays.none() : ComputedArrays.of(cache, KIND, key(scenario, thorax));
    }

    private static String key(Scenario scenario, Thorax thorax) {
        Map<String, Object> settings = scenario.toMap();
        OF_THE_RUN.forEach(setting -> settings.remove(setting.key()));
        String trace = scenario.trace().map(Hashes::sha256).orElse("");
        return body(scenario, thorax) + "\n" + settings + "\n" + trace;
    }

    /** A virtual body by its name, another by its content. */
    @SuppressWarnings("ReferenceEquality") // equal bodies that are not the same object are compared by content
    private static String body(Scenario scenario, Thorax thorax) {
        if (scenario.isVirtual() && thorax == SimulationRun.loadThorax(scenario)) {
            return scenario.anatomy() + " " + OrganSettings.budget(scenario).vertices();
        }
        return thorax.content();
    }
}
