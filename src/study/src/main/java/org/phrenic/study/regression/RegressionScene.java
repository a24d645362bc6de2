package org.phrenic.study.regression;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/**
 * A scene of the regression list.
 *
 * @param name of its file of references
 * @param settings what differs from a quiet breath, as {@code key=value}
 * @param changes made while it runs, as {@code STEP:key=value}
 * @param timesS when it is observed, s; more than 0, ascending
 * @param toleranceMm largest distance of a node from its reference, mm
 * @param observableTolerance largest difference of an observable from its reference, as a share of that or of 1 if that
 *     is more
 */
record RegressionScene(
        String name,
        List<String> settings,
        List<String> changes,
        double[] timesS,
        double toleranceMm,
        double observableTolerance) {
    private static final List<String> KEYS =
            List.of("name", "settings", "changes", "times_s", "tolerance_mm", "observable_tolerance");

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
        map.requireOnly(KEYS);
        String name = name(map);
        double[] times = map.numbers("times_s");
        for (int i = 0; i < times.length; i++) {
            if (!(times[i] > (i == 0 ? 0 : times[i - 1]))) {
                throw map.bad("times_s", "found " + times[i] + ", expected times above 0, each above the one before");
            }
        }
        if (times.length == 0) {
            throw map.bad("times_s", "found none, expected at least one");
        }
        RegressionScene scene = new RegressionScene(
                name,
                map.texts("settings"),
                map.has("changes") ? map.texts("changes") : List.of(),
                times,
                positive(map, "tolerance_mm"),
                positive(map, "observable_tolerance"));
        try {
            scene.scenario();
        } catch (BadInputException bad) {
            throw map.bad("settings", "found a scene that cannot be (" + bad.getMessage() + "), expected a scenario");
        }
        return scene;
    }

    /** The name of an entry, which is that of a file as well. */
    static String name(YamlMap map) {
        String name = map.text("name");
        if (!name.matches("[a-z0-9-]+")) {
            throw map.bad("name", "found '" + name + "', expected small letters, digits and hyphens");
        }
        return name;
    }

    static double positive(YamlMap map, String key) {
        double value = map.number(key);
        if (!(value > 0)) {
            throw map.bad(key, "found " + value + ", expected more than 0");
        }
        return value;
    }

    /** What is simulated. */
    Scenario scenario() {
        Scenario scenario = Scenario.defaults().with(settings.toArray(String[]::new));
        return changes.isEmpty()
                ? scenario
                : scenario.withChanges(
                        changes.stream().map(ScheduledChange::parse).toList());
    }

    /** Settings, changes and times in one line: references of a scene with another line are of another scene. */
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
