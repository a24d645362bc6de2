package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;

/**
 * Every stability case under every integrator, and how each ended.
 *
 * @param cases titles by key, in order
 * @param integrators in order
 * @param cells one a case and integrator, case by case
 */
public record StabilityStudy(Map<String, String> cases, List<IntegratorKind> integrators, List<CaseResult> cells) {
    /**
     * What to run.
     *
     * @param only keys of cases; empty for all
     * @param quick whether to run the short version: coarser domes, shorter times
     * @param nodeEvaluations evaluations of the force on a node that a cell may spend: one that needs more ends
     *     earlier, which its simulated time shows
     * @param verletEvaluations the same for velocity Verlet, the default integrator
     * @param threads cases at a time, one thread each
     */
    public record Settings(
            List<String> only,
            List<IntegratorKind> integrators,
            boolean quick,
            double nodeEvaluations,
            double verletEvaluations,
            int threads) {
        /** All cells of the long version: Verlet's hour of quiet breathing is an hour. */
        public static final Settings LONG =
                new Settings(List.of(), List.of(IntegratorKind.values()), false, 5e8, 5e10, 1);

        /** All cells of the short version. */
        public static final Settings QUICK =
                new Settings(List.of(), List.of(IntegratorKind.values()), true, 2e7, 2e7, 1);

        public Settings withEvaluations(double evaluations) {
            return new Settings(only, integrators, quick, evaluations, evaluations, threads);
        }

        public Settings withThreads(int count) {
            return new Settings(only, integrators, quick, nodeEvaluations, verletEvaluations, count);
        }

        /** Only these cases under these integrators. */
        public Settings only(List<String> keys, List<IntegratorKind> kinds) {
            return new Settings(keys, kinds, quick, nodeEvaluations, verletEvaluations, threads);
        }

        private double evaluations(IntegratorKind integrator) {
            return integrator == IntegratorKind.VERLET ? verletEvaluations : nodeEvaluations;
        }
    }

    public StabilityStudy {
        cases = Collections.unmodifiableMap(new LinkedHashMap<>(cases));
        integrators = List.copyOf(integrators);
        cells = List.copyOf(cells);
    }

    /** Keys of all cases, in order. */
    public static List<String> caseKeys() {
        return StabilityCases.all(true).stream().map(StabilityCase::key).toList();
    }

    /**
     * Runs the cells, the last cases first, for they take longest; the same settings give the same cells on any number
     * of threads.
     */
    public static StabilityStudy of(Settings settings, ProgressListener progress) {
        List<StabilityCase> cases = StabilityCases.all(settings.quick()).stream()
                .filter(c -> settings.only().isEmpty() || settings.only().contains(c.key()))
                .toList();
        int total = cases.size() * settings.integrators().size();
        AtomicInteger count = new AtomicInteger();
        Consumer<CaseResult> done = cell -> {
            synchronized (count) {
                progress.done(count.incrementAndGet(), total, description(cell));
            }
        };
        List<BatchRunner.Job<List<CaseResult>>> jobs = new ArrayList<>();
        Map<String, String> titles = new LinkedHashMap<>();
        for (StabilityCase each : cases) {
            jobs.add(0, new BatchRunner.Job<>(each.key(), () -> cells(each, settings, done)));
            titles.put(each.key(), each.title());
        }
        List<CaseResult> cells = new ArrayList<>();
        BatchRunner.run(jobs, settings.threads(), (number, of, what) -> {}).forEach(row -> cells.addAll(0, row));
        return new StabilityStudy(titles, settings.integrators(), cells);
    }

    private static List<CaseResult> cells(StabilityCase stabilityCase, Settings settings, Consumer<CaseResult> done) {
        double duration = settings.quick() ? stabilityCase.quickS() : stabilityCase.durationS();
        ReferenceSolution reference = ReferenceSolution.of(stabilityCase, duration, CaseRun.SAMPLE_S);
        List<CaseResult> cells = new ArrayList<>();
        for (IntegratorKind kind : settings.integrators()) {
            CaseResult cell = CaseRun.of(stabilityCase, kind, reference, duration, settings.evaluations(kind));
            cells.add(cell);
            done.accept(cell);
        }
        return cells;
    }

    private static String description(CaseResult cell) {
        return cell.caseKey() + ", " + cell.integrator().label() + ": "
                + cell.outcome().label()
                + (cell.sentence().isEmpty() ? "" : " (" + cell.sentence() + ")");
    }

    /** Whether no cell failed silently. */
    public boolean passes() {
        return cells.stream().noneMatch(c -> c.outcome() == CaseResult.Outcome.SILENT_FAILURE);
    }
}
