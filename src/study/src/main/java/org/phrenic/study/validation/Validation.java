package org.phrenic.study.validation;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.Attempts;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;
import org.phrenic.study.validation.Finding.Verdict;

/**
 * Compares simulated breaths with the physiology table. Each preset of the table is run once on each body, and every
 * row receives a verdict.
 *
 * @param table the ranges
 * @param settings common to all runs, apart from preset and body
 * @param bodies in the order given
 * @param failures breaths that could not be computed, with their reasons
 */
public record Validation(PhysiologyTable table, Scenario settings, List<Body> bodies, List<String> failures) {

    /**
     * Results of one body.
     *
     * @param anatomy as given
     * @param name of the thorax
     * @param sex derived from the name
     * @param findings one per row of the table
     */
    public record Body(String anatomy, String name, Optional<String> sex, List<Finding> findings) {
        public Body {
            findings = List.copyOf(findings);
        }

        long count(Verdict verdict) {
            return findings.stream().filter(f -> f.verdict() == verdict).count();
        }
    }

    public Validation {
        bodies = List.copyOf(bodies);
        failures = List.copyOf(failures);
    }

    /**
     * Runs the simulations and compares the results with the table.
     *
     * @param settings of all runs; preset and anatomy are replaced
     * @param anatomies virtual bodies or folders
     * @param only presets to run; empty for all presets of the table
     * @param threads number of concurrent runs
     */
    public static Validation of(
            PhysiologyTable table,
            Scenario settings,
            List<String> anatomies,
            Collection<String> only,
            int threads,
            ProgressListener progress) {
        Scenario single = settings.with("threads=1");
        Set<String> presets = presets(table, only);
        only.stream().filter(preset -> !presets.contains(preset)).findFirst().ifPresent(preset -> {
            throw new BadInputException("--preset: found '" + preset + "', of which the table has no row, expected "
                    + String.join(", ", presets(table, List.of())));
        });
        List<Thorax> thoraxes = new ArrayList<>();
        List<BatchRunner.Job<BreathSeries>> jobs = new ArrayList<>();
        for (String anatomy : anatomies) {
            Scenario on = single.with(List.of(Assignment.read("--anatomy " + anatomy, "anatomy", anatomy)));
            Thorax thorax = SimulationRun.loadThorax(on);
            thorax.notes().forEach(progress::note);
            thoraxes.add(thorax);
            for (String preset : presets) {
                Scenario run = on.with("preset=" + preset);
                jobs.add(new BatchRunner.Job<>(
                        name(anatomy, preset),
                        () -> PresetRun.of(run, thorax, PresetRun.SAMPLE_S, observables(table, preset))));
            }
        }
        Attempts<BreathSeries> series = Attempts.of(jobs, threads, progress);
        List<Body> bodies = new ArrayList<>();
        for (int b = 0; b < anatomies.size(); b++) {
            Map<String, BreathSeries> runs = new LinkedHashMap<>();
            for (String preset : presets) {
                runs.put(preset, series.result(name(anatomies.get(b), preset)).orElse(null));
            }
            Optional<String> sex = sex(thoraxes.get(b).name());
            bodies.add(new Body(anatomies.get(b), thoraxes.get(b).name(), sex, judge(table.ranges(), runs, sex)));
        }
        return new Validation(table, settings, bodies, series.failures());
    }

    private static String name(String anatomy, String preset) {
        return anatomy + ", " + preset;
    }

    private static Set<String> presets(PhysiologyTable table, Collection<String> only) {
        Set<String> presets = new LinkedHashSet<>();
        for (ReferenceRange row : table.ranges()) {
            boolean asked =
                    row.preset().filter(p -> only.isEmpty() || only.contains(p)).isPresent();
            if (asked) {
                presets.add(row.preset().get());
                row.againstPreset()
                        .filter(p -> only.isEmpty() || only.contains(p))
                        .ifPresent(presets::add);
            }
        }
        return presets;
    }

    /** Observables that the rows of a preset need. */
    private static Set<String> observables(PhysiologyTable table, String preset) {
        Set<String> names = new LinkedHashSet<>();
        for (ReferenceRange row : table.ranges()) {
            if (row.preset().filter(preset::equals).isPresent()) {
                names.addAll(row.observables());
                names.add(row.against());
            }
            if (row.againstPreset().filter(preset::equals).isPresent()) {
                names.add(row.against());
            }
        }
        return names;
    }

    /** Male or female, if the name of a body contains the word. */
    static Optional<String> sex(String name) {
        List<String> words = List.of(name.toLowerCase(Locale.ROOT).split("[^a-z]+"));
        return List.of("female", "male").stream().filter(words::contains).findFirst();
    }

    /**
     * Evaluates each row.
     *
     * @param runs by preset; null for one that failed
     */
    static List<Finding> judge(List<ReferenceRange> rows, Map<String, BreathSeries> runs, Optional<String> sex) {
        return rows.stream().map(row -> judge(row, runs, sex)).toList();
    }

    private static Finding judge(ReferenceRange row, Map<String, BreathSeries> runs, Optional<String> sex) {
        if (row.preset().isEmpty()) {
            return notMeasurable(row, row.note());
        }
        if (row.body().isPresent() && !row.body().equals(sex)) {
            return notMeasurable(
                    row,
                    sex.isEmpty()
                            ? "the body's name says neither male nor female"
                            : "a range of " + (row.body().get().equals("male") ? "men" : "women"));
        }
        String preset = row.preset().get();
        String second = row.againstPreset().orElse(preset);
        if (!runs.containsKey(preset) || !runs.containsKey(second)) {
            return notMeasurable(row, "the preset was not asked for");
        }
        BreathSeries series = runs.get(preset);
        BreathSeries other = runs.get(second);
        if (series == null || other == null) {
            return notMeasurable(row, "the breath could not be computed");
        }
        double value = row.factor() * row.reduction().of(series, other, row.observables(), row.against(), row.share());
        if (!Double.isFinite(value)) {
            return notMeasurable(row, "the body or the breath lacks what it is measured on");
        }
        if (row.contains(value)) {
            return new Finding(row, Verdict.WITHIN, value, "");
        }
        return new Finding(
                row, Verdict.OUT, value, row.missReason().isEmpty() ? Finding.UNEXPLAINED : row.missReason());
    }

    private static Finding notMeasurable(ReferenceRange row, String reason) {
        return new Finding(row, Verdict.NOT_MEASURABLE, Double.NaN, reason);
    }

    /** Whether every breath was computed and no binding range is missed. */
    public boolean passes() {
        return failures.isEmpty()
                && bodies.stream().flatMap(b -> b.findings().stream()).noneMatch(Finding::isMiss);
    }
}
