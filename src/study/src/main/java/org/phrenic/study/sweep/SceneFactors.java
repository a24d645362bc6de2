package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.KeySuggestion;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/** The factors of a simulation: settings of its scenario, size and shape of its body, persons of a cohort. */
final class SceneFactors {
    /** Key of the factor of persons, who stand in place of a body. */
    static final String PERSON = "person";

    /** Settings that do not change a breath, or that a study sets itself. */
    private static final Set<String> RESERVED =
            Set.of("name", "threads", "steps", "changes", "record_every_s", "meshes_every_s");

    private final Scenario scenario;
    private final boolean ofPersons;
    private final BodyPool bodies = new BodyPool();
    private final Cohort cohort = Cohort.shipped();

    /** @param ofPersons whether a factor states persons */
    SceneFactors(Scenario scenario, boolean ofPersons) {
        this.scenario = scenario.with(Numerics.THREADS, 1);
        this.ofPersons = ofPersons;
    }

    static String near(String name, List<String> known) {
        return KeySuggestion.nearest(name, known)
                .map(nearest -> "did you mean '" + nearest + "'?")
                .orElse("expected one of " + String.join(", ", known));
    }

    double[] limits(String key) {
        if (BodyFactors.has(key)) {
            return BodyFactors.limits(key);
        }
        if (key.equals(PERSON)) {
            return new double[0];
        }
        Setting<?> setting = setting(key);
        return setting instanceof NumberSetting number
                ? new double[] {number.minimum(), number.maximum()}
                : new double[0];
    }

    private static Setting<?> setting(String key) {
        List<String> known = Stream.concat(
                        Settings.keys().stream().filter(k -> !RESERVED.contains(k)),
                        Stream.concat(Stream.of(PERSON), BodyFactors.keys().stream()))
                .toList();
        return Settings.all().stream()
                .filter(setting -> setting.key().equals(key) && known.contains(key))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "factor '" + key + "': found an unknown factor, " + near(key, known)));
    }

    void check(String key, String value) {
        if (BodyFactors.has(key)) {
            BodyFactors.check(key, value);
        } else if (key.equals(PERSON)) {
            Person.parse(value);
        } else {
            Assignment.read("factor '" + key + "'", setting(key).key(), value);
        }
    }

    private static Optional<Person> person(SweepPoint point) {
        int at = point.keys().indexOf(PERSON);
        return at < 0
                ? Optional.empty()
                : Optional.of(Person.parse(point.values().get(at)));
    }

    List<String> traitNames() {
        return ofPersons ? Person.TRAITS : List.of();
    }

    List<String> traits(SweepPoint point) {
        return person(point).map(Person::traits).orElse(List.of());
    }

    /** The scenario of a point, on one thread. */
    Scenario scenario(SweepPoint point) {
        List<Assignment> assignments = new ArrayList<>();
        for (int i = 0; i < point.keys().size(); i++) {
            String key = point.keys().get(i);
            if (Settings.keys().contains(key)) {
                assignments.add(Assignment.read(
                        "run " + point.index(), key, point.values().get(i)));
            }
        }
        person(point).ifPresent(p -> assignments.add(Assignment.of("person", RunSettings.ANATOMY, cohort.body(p))));
        return scenario.stating(assignments);
    }

    /** The body of a point. */
    Thorax body(SweepPoint point, Scenario run) {
        return bodies.body(run, person(point).map(cohort::variation).or(() -> BodyFactors.variation(point)));
    }
}
