package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;

/**
 * Results of all stability cases under all integrators.
 *
 * @param cases titles by key, in order
 * @param integrators in order
 * @param cells one per case and integrator, grouped by case
 */
public record StabilityStudy(Map<String, String> cases, List<IntegratorKind> integrators, List<CaseResult> cells) {
    /**
     * Selection and limits of a study.
     *
     * @param only keys of cases; empty for all
     * @param quick whether to run the short version: coarser domes and thoraxes, shorter times
     * @param scan folder of a scanned body; without it its cases are left out
     * @param nodeEvaluations budget of force evaluations times nodes per cell. A cell that needs more ends early, which
     *     its simulated time shows.
     * @param verletEvaluations the same for velocity Verlet, the default integrator
     * @param threads number of concurrent cells, one thread each
     */
    public record Settings(
            List<String> only,
            List<IntegratorKind> integrators,
            boolean quick,
            Optional<String> scan,
            double nodeEvaluations,
            double verletEvaluations,
            int threads) {
        /** All cells of the long version. The budget of Verlet suffices for one simulated hour of quiet breathing. */
        public static final Settings LONG =
                new Settings(List.of(), List.of(IntegratorKind.values()), false, Optional.empty(), 5e8, 6e10, 1);

        /** All cells of the short version. */
        public static final Settings QUICK =
                new Settings(List.of(), List.of(IntegratorKind.values()), true, Optional.empty(), 4e7, 4e7, 1);

        public Settings withEvaluations(double evaluations) {
            return new Settings(only, integrators, quick, scan, evaluations, evaluations, threads);
        }

        public Settings withThreads(int count) {
            return new Settings(only, integrators, quick, scan, nodeEvaluations, verletEvaluations, count);
        }

        /** A copy with only these cases and integrators. */
        public Settings only(List<String> keys, List<IntegratorKind> kinds) {
            return new Settings(keys, kinds, quick, scan, nodeEvaluations, verletEvaluations, threads);
        }

        /** A copy with the cases of a scanned body. */
        public Settings withScan(Optional<String> folder) {
            return new Settings(only, integrators, quick, folder, nodeEvaluations, verletEvaluations, threads);
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

    /**
     * Keys of all cases, in order.
     *
     * @param scan folder of a scanned body, if there is one
     */
    public static List<String> caseKeys(Optional<String> scan) {
        return StabilityCases.all(true, scan).stream().map(StabilityCase::key).toList();
    }

    /**
     * Runs the cells. The last cases run first because they take longest. The same settings give the same results on
     * any number of threads.
     */
    public static StabilityStudy of(Settings settings, ProgressListener progress) {
        List<StabilityCase> cases = StabilityCases.all(settings.quick(), settings.scan()).stream()
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

    /** Whether no cell failed silently or stopped, and every body returned to where it began. */
    public boolean passes() {
        return cells.stream().noneMatch(CaseResult::fails);
    }
}
