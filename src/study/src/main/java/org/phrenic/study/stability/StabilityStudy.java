package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;

/**
 * Every hard case under every integrator, and how each ended.
 *
 * @param titles of the cases, by their place in {@link #keys}
 * @param keys of the cases, in order
 * @param integrators the integrators, in order
 * @param cells one a case and integrator, case by case
 */
public record StabilityStudy(
        List<String> keys, List<String> titles, List<IntegratorKind> integrators, List<CaseResult> cells) {

    /**
     * What to run.
     *
     * @param only keys of cases; empty for all
     * @param kinds integrators
     * @param quick whether to run the short version: coarser domes, shorter times
     * @param nodeEvaluations evaluations of the force on a node that a cell may spend: one that needs more ends
     *     earlier, which its simulated time shows
     * @param verletEvaluations the same for velocity Verlet, which is what the program uses unless told otherwise
     * @param threads cases at a time, one thread each
     */
    public record Settings(
            List<String> only,
            List<IntegratorKind> kinds,
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

        /** As much for every integrator. */
        public Settings spending(double evaluations) {
            return new Settings(only, kinds, quick, evaluations, evaluations, threads);
        }

        /** So many cases at a time. */
        public Settings on(int count) {
            return new Settings(only, kinds, quick, nodeEvaluations, verletEvaluations, count);
        }

        /** Only these cases under these integrators. */
        public Settings of(List<String> keys, List<IntegratorKind> integrators) {
            return new Settings(keys, integrators, quick, nodeEvaluations, verletEvaluations, threads);
        }

        private double evaluations(IntegratorKind kind) {
            return kind == IntegratorKind.VERLET ? verletEvaluations : nodeEvaluations;
        }
    }

    public StabilityStudy {
        keys = List.copyOf(keys);
        titles = List.copyOf(titles);
        integrators = List.copyOf(integrators);
        cells = List.copyOf(cells);
    }

    /** Keys of all cases, in order. */
    public static List<String> caseKeys() {
        return StabilityCases.all(true).stream().map(StabilityCase::key).toList();
    }

    /**
     * Runs the cells, the cases last in the list first, for they take longest; the same settings give the same cells,
     * on any number of threads.
     */
    public static StabilityStudy of(Settings settings, ProgressListener progress) {
        List<StabilityCase> cases = StabilityCases.all(settings.quick()).stream()
                .filter(c -> settings.only().isEmpty() || settings.only().contains(c.key()))
                .toList();
        CellsDone done = new CellsDone(cases.size() * settings.kinds().size(), progress);
        List<BatchRunner.Job<List<CaseResult>>> jobs = new ArrayList<>();
        for (StabilityCase hard : cases) {
            jobs.add(0, new BatchRunner.Job<>(hard.key(), () -> cells(hard, settings, done)));
        }
        List<CaseResult> cells = new ArrayList<>();
        for (List<CaseResult> row : BatchRunner.run(jobs, settings.threads(), (count, total, what) -> {})) {
            cells.addAll(0, row);
        }
        return new StabilityStudy(
                cases.stream().map(StabilityCase::key).toList(),
                cases.stream().map(StabilityCase::title).toList(),
                settings.kinds(),
                cells);
    }

    private static List<CaseResult> cells(StabilityCase hard, Settings settings, CellsDone done) {
        double duration = settings.quick() ? hard.quickS() : hard.durationS();
        ReferenceSolution trusted = ReferenceSolution.of(hard, duration, CaseRun.SAMPLE_S);
        List<CaseResult> cells = new ArrayList<>();
        for (IntegratorKind kind : settings.kinds()) {
            CaseResult cell = CaseRun.of(hard, kind, trusted, duration, settings.evaluations(kind));
            cells.add(cell);
            done.count(cell);
        }
        return cells;
    }

    /** Counts cells and tells of each. */
    private static final class CellsDone {
        private final int total;
        private final ProgressListener progress;
        private int count;

        CellsDone(int total, ProgressListener progress) {
            this.total = total;
            this.progress = progress;
        }

        synchronized void count(CaseResult cell) {
            progress.done(
                    ++count,
                    total,
                    cell.caseKey() + ", " + cell.integrator().label() + ": "
                            + cell.outcome().label()
                            + (cell.sentence().isEmpty() ? "" : " (" + cell.sentence() + ")"));
        }
    }

    /** Whether no cell failed in silence. */
    public boolean passes() {
        return cells.stream().noneMatch(c -> c.outcome() == CaseOutcome.SILENT_FAILURE);
    }
}
