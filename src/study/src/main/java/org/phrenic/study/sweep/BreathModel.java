package org.phrenic.study.sweep;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.scenario.Scenario;
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

    /** Sampling interval, s. End-inspiration moves with most parameters. */
    static final double SAMPLE_S = 0.02;

    private final SceneFactors factors;
    private final List<ResponseSpec> responses;
    private final List<String> series;
    private final Set<String> needed = new LinkedHashSet<>();

    /** @throws IllegalArgumentException with one sentence, if there is no response or an observable is unknown */
    BreathModel(SceneFactors factors, List<ResponseSpec> responses, List<String> series) {
        this.factors = factors;
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
                throw new IllegalArgumentException(
                        "found an unknown observable '" + name + "', " + SceneFactors.near(name, known));
            }
        }
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
        return factors.limits(key);
    }

    @Override
    public void check(String key, String value) {
        factors.check(key, value);
    }

    @Override
    public List<String> traitNames() {
        return factors.traitNames();
    }

    @Override
    public List<String> traits(SweepPoint point) {
        return factors.traits(point);
    }

    @Override
    public SweepOutcome evaluate(SweepPoint point) {
        Scenario run = factors.scenario(point);
        try (Simulation simulation = Simulation.of(run, factors.body(point, run))) {
            BreathSeries breath = PresetRun.of(simulation, SAMPLE_S, needed);
            double[] values = responses.stream()
                    .mapToDouble(response -> response.valueIn(breath))
                    .toArray();
            double[][] curves =
                    series.stream().map(name -> seriesOf(breath, name)).toArray(double[][]::new);
            return new SweepOutcome(values, simulation.stateHash(), curves);
        }
    }

    private static double[] seriesOf(BreathSeries breath, String name) {
        double[] values = resampled(breath, name);
        if (Arrays.stream(values).noneMatch(Double::isFinite)) {
            throw new IllegalStateException("series '" + name + "': found no number, expected a body that has " + name);
        }
        return values;
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
