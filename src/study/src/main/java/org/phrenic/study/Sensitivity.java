package org.phrenic.study;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * One-at-a-time sensitivity of observables to parameters. Each parameter is lowered and raised by 10 %, limited to its
 * range. The sensitivity is the relative change of the observable over the relative change of the parameter, in per
 * cent per per cent: ((q+ - q-) / q0) / ((p+ - p-) / p0).
 *
 * @param preset of breathing, one breath from rest
 * @param anatomy body
 * @param observables whose change from end-expiration to end-inspiration is evaluated
 * @param reference these changes with unmodified parameters
 * @param rows one per parameter whose value is not 0
 * @param failures breaths that could not be computed, with their reasons
 */
public record Sensitivity(
        String preset,
        String anatomy,
        List<String> observables,
        double[] reference,
        List<Row> rows,
        List<String> failures) {
    private static final double STEP = 0.1;
    private static final String UNALTERED = "nothing altered";
    /**
     * Sampling interval, s. It is shorter than for validation because most parameters shift end-inspiration slightly.
     */
    private static final double SAMPLE_S = 0.01;

    private static final List<String> OBSERVABLES =
            List.of(("dome_right_mm dome_left_mm central_tendon_mm anterior_right_mm"
                            + " posterior_right_mm fibre_shortening_percent lung_volume_change_ml transverse_change_mm"
                            + " sternum_cranial_mm sternum_ventral_mm liver_si_mm liver_ap_mm")
                    .split(" "));

    /**
     * Sensitivity to one parameter.
     *
     * @param parameter that was changed
     * @param from lower value
     * @param to higher value
     * @param effects per cent per per cent, one per observable; NaN where the observable does not change during the
     *     breath, or a breath failed
     */
    public record Row(Parameter parameter, double from, double to, double[] effects) {}

    /**
     * Runs the study: two breaths for each parameter that the material uses and whose value is not 0, and one with
     * unmodified parameters.
     *
     * @param scenario preset, body, resolution and material
     * @param threads number of concurrent runs
     */
    public static Sensitivity of(Scenario scenario, int threads, ProgressListener progress) {
        Scenario single = scenario.with(Numerics.THREADS, 1);
        Thorax thorax = SimulationRun.loadThorax(single);
        List<Parameter> parameters = scenario.material().parameters().stream()
                .filter(p -> single.get(p) != 0)
                .toList();
        List<double[]> ends = new ArrayList<>();
        List<BatchRunner.Job<double[]>> jobs = new ArrayList<>();
        jobs.add(new BatchRunner.Job<>(UNALTERED, () -> breathChanges(single, thorax)));
        for (Parameter parameter : parameters) {
            double value = single.get(parameter);
            double[] pair = {
                Math.max(parameter.minimum(), value * (1 - STEP)), Math.min(parameter.maximum(), value * (1 + STEP))
            };
            ends.add(pair);
            for (double end : pair) {
                Scenario altered = single.with(parameter, end);
                jobs.add(new BatchRunner.Job<>(name(parameter, end), () -> breathChanges(altered, thorax)));
            }
        }
        Attempts<double[]> seen = Attempts.of(jobs, threads, progress);
        double[] reference = changes(seen, UNALTERED);
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < parameters.size(); i++) {
            double[] pair = ends.get(i);
            double share = (pair[1] - pair[0]) / single.get(parameters.get(i));
            double[] low = changes(seen, name(parameters.get(i), pair[0]));
            double[] high = changes(seen, name(parameters.get(i), pair[1]));
            rows.add(new Row(parameters.get(i), pair[0], pair[1], effects(reference, low, high, share)));
        }
        return new Sensitivity(scenario.preset(), scenario.anatomy(), OBSERVABLES, reference, rows, seen.failures());
    }

    private static String name(Parameter parameter, double value) {
        return format("%s %.4g", parameter.key(), value);
    }

    /** What was observed in a breath; NaN if it failed. */
    private static double[] changes(Attempts<double[]> seen, String name) {
        return seen.result(name)
                .orElseGet(() ->
                        OBSERVABLES.stream().mapToDouble(none -> Double.NaN).toArray());
    }

    /** Sensitivities in per cent per per cent, for a parameter change of {@code share} of its value. */
    public static double[] effects(double[] reference, double[] low, double[] high, double share) {
        double[] effects = new double[reference.length];
        Arrays.setAll(effects, i -> reference[i] == 0 ? Double.NaN : (high[i] - low[i]) / (reference[i] * share));
        return effects;
    }

    private static double[] breathChanges(Scenario scenario, Thorax thorax) {
        BreathSeries series = PresetRun.of(scenario, thorax, SAMPLE_S, List.of());
        return OBSERVABLES.stream().mapToDouble(series::meanChange).toArray();
    }
}
