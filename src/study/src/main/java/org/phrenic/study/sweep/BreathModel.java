package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.LinkedHashSet;
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
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;
import org.phrenic.study.measure.SceneObservables;

/**
 * A breath from rest as the model of a study: factors are settings of the scenario and size and shape of the body,
 * responses are reductions of its observables. Each run uses one thread.
 */
final class BreathModel implements SweepModel {
    static final String NAME = "breath";
    /** Key of the factor of persons, who stand in place of a body. */
    static final String PERSON = "person";

    /** Sampling interval, s. End-inspiration moves with most parameters. */
    private static final double SAMPLE_S = 0.02;

    /** Settings that do not change a breath, or that a study sets itself. */
    private static final Set<String> RESERVED =
            Set.of("name", "threads", "steps", "changes", "record_every_s", "meshes_every_s");

    private final Scenario scenario;
    private final List<ResponseSpec> responses;
    private final List<String> series;
    private final Set<String> needed = new LinkedHashSet<>();
    private final BodyPool bodies = new BodyPool();
    private final Cohort cohort = Cohort.shipped();
    private final boolean ofPersons;

    /**
     * @param ofPersons whether a factor states persons
     * @throws IllegalArgumentException with one sentence, if there is no response or an observable is unknown
     */
    BreathModel(Scenario scenario, List<ResponseSpec> responses, List<String> series, boolean ofPersons) {
        this.ofPersons = ofPersons;
        this.scenario = scenario.with(Numerics.THREADS, 1);
        this.responses = List.copyOf(responses);
        this.series = List.copyOf(series);
        if (responses.isEmpty()) {
            throw new IllegalArgumentException("found no response, expected at least one");
        }
        responses.forEach(response -> needed.addAll(response.needed()));
        needed.addAll(series);
        List<String> known = Stream.concat(Observation.COLUMNS.stream(), SceneObservables.names().stream())
                .toList();
        for (String name : needed) {
            if (!known.contains(name)) {
                throw new IllegalArgumentException("found an unknown observable '" + name + "', " + near(name, known));
            }
        }
    }

    private static String near(String name, List<String> known) {
        return KeySuggestion.nearest(name, known)
                .map(nearest -> "did you mean '" + nearest + "'?")
                .orElse("expected one of " + String.join(", ", known));
    }

    @Override
    public List<String> responses() {
        return responses.stream().map(ResponseSpec::name).toList();
    }

    @Override
    public List<String> series() {
        return series;
    }

    @Override
    public double[] limits(String key) {
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

    @Override
    public void check(String key, String value) {
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

    @Override
    public List<String> traitNames() {
        return ofPersons ? Person.TRAITS : List.of();
    }

    @Override
    public List<String> traits(SweepPoint point) {
        return person(point).map(Person::traits).orElse(List.of());
    }

    @Override
    public SweepOutcome evaluate(SweepPoint point) {
        List<Assignment> assignments = new ArrayList<>();
        for (int i = 0; i < point.keys().size(); i++) {
            String key = point.keys().get(i);
            if (!BodyFactors.has(key) && !key.equals(PERSON)) {
                assignments.add(Assignment.read(
                        "run " + point.index(), key, point.values().get(i)));
            }
        }
        Optional<Person> person = person(point);
        person.ifPresent(p -> assignments.add(Assignment.of("person", RunSettings.ANATOMY, cohort.body(p))));
        Scenario run = scenario.with(assignments);
        Thorax body = bodies.body(run, person.map(cohort::variation).or(() -> BodyFactors.variation(point)));
        try (Simulation simulation = Simulation.of(run, body)) {
            BreathSeries breath = PresetRun.of(simulation, SAMPLE_S, needed);
            double[] values = responses.stream()
                    .mapToDouble(response -> response.of(breath))
                    .toArray();
            double[][] curves =
                    series.stream().map(name -> resampled(breath, name)).toArray(double[][]::new);
            return new SweepOutcome(values, simulation.stateHash(), curves);
        }
    }

    /** An observable at equal steps from the first to the last sample. */
    private static double[] resampled(BreathSeries breath, String name) {
        double[] values = new double[SweepOutcome.SERIES_POINTS];
        int last = breath.lastRow(breath.breathCount() - 1);
        double start = breath.value("time_s", 0);
        double end = breath.value("time_s", last);
        int row = 0;
        for (int i = 0; i < values.length; i++) {
            double time = start + (end - start) * i / (values.length - 1);
            while (row < last - 1 && breath.value("time_s", row + 1) < time) {
                row++;
            }
            double before = breath.value("time_s", row);
            double share = (time - before) / (breath.value("time_s", row + 1) - before);
            double from = breath.value(name, row);
            values[i] = from + share * (breath.value(name, row + 1) - from);
        }
        return values;
    }
}
