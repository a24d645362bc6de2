package org.phrenic.study.regression;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.document.Key;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/**
 * Scene of the regression list.
 *
 * @param name of its reference file
 * @param settings that differ from a quiet breath, as {@code key=value}
 * @param changes applied during the run, as {@code STEP:key=value}
 * @param timesS observation times, s; positive, ascending
 * @param toleranceMm largest distance of a node from its reference, mm
 * @param observableTolerance largest error of an observable relative to max(|reference|, 1)
 */
record RegressionScene(
        String name,
        List<String> settings,
        @Key(absent = "") List<String> changes,
        double[] timesS,
        @Key(above = 0) double toleranceMm,
        @Key(above = 0) double observableTolerance) {
    /** All scenes of a list. */
    static List<RegressionScene> list(YamlMap yaml) {
        yaml.requireOnly(List.of("scenes", "attempts"));
        List<RegressionScene> scenes = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (YamlMap map : yaml.maps("scenes")) {
            RegressionScene scene = of(map);
            if (!names.add(scene.name)) {
                throw map.bad("name", "found '" + scene.name + "' a second time, expected each name once");
            }
            scenes.add(scene);
        }
        if (scenes.isEmpty()) {
            throw yaml.bad("scenes", "found none, expected at least one");
        }
        return scenes;
    }

    private static RegressionScene of(YamlMap map) {
        RegressionScene scene = map.bind(RegressionScene.class);
        requireFileName(map, scene.name);
        double last = 0;
        for (double time : scene.timesS) {
            if (!(time > last)) {
                throw map.bad("times_s", "found " + time + ", expected times above 0, each above the one before");
            }
            last = time;
        }
        if (scene.timesS.length == 0) {
            throw map.bad("times_s", "found none, expected at least one");
        }
        try {
            scene.scenario();
        } catch (BadInputException bad) {
            throw map.bad("settings", "found a scene that cannot be (" + bad.getMessage() + "), expected a scenario");
        }
        return scene;
    }

    /** Requires that the name is a valid file name. */
    static void requireFileName(YamlMap map, String name) {
        if (!name.matches("[a-z0-9-]+")) {
            throw map.bad("name", "found '" + name + "', expected small letters, digits and hyphens");
        }
    }

    /** The simulated scenario. */
    Scenario scenario() {
        Scenario scenario = Scenario.defaults().with(settings.toArray(String[]::new));
        return changes.isEmpty()
                ? scenario
                : scenario.withChanges(
                        changes.stream().map(ScheduledChange::parse).toList());
    }

    /** Settings, changes and times in one line; references are valid only for the same line. */
    String specification() {
        StringBuilder line = new StringBuilder(String.join(" ", settings));
        changes.forEach(change -> line.append(' ').append(change));
        line.append(" at");
        for (double time : timesS) {
            line.append(' ').append(time);
        }
        return line.toString();
    }
}
