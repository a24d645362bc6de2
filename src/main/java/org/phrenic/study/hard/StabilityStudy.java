package org.phrenic.study.hard;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.study.StudyProgress;

/**
 * Every hard case under every integrator, and how each ended.
 *
 * @param titles of the cases, by their place in {@link #keys}
 * @param keys of the cases, in order
 * @param kinds the integrators, in order
 * @param cells one a case and integrator, case by case
 */
public record StabilityStudy(List<String> keys, List<String> titles, List<IntegratorKind> kinds, List<Cell> cells) {

    /**
     * What to run.
     *
     * @param only keys of cases; empty for all
     * @param kinds integrators
     * @param quick whether to run the short version: coarser domes, shorter times
     * @param nodeEvaluations evaluations of the force on a node that a cell may spend: one that needs more ends earlier, which its simulated time shows
     */
    public record Settings(List<String> only, List<IntegratorKind> kinds, boolean quick, double nodeEvaluations) {
        /** All cells of the long version. */
        public static final Settings LONG = new Settings(List.of(), List.of(IntegratorKind.values()), false, 2.5e9);

        /** All cells of the short version. */
        public static final Settings QUICK = new Settings(List.of(), List.of(IntegratorKind.values()), true, 2e7);
    }

    public StabilityStudy {
        keys = List.copyOf(keys);
        titles = List.copyOf(titles);
        kinds = List.copyOf(kinds);
        cells = List.copyOf(cells);
    }

    /** Keys of all cases, in order. */
    public static List<String> caseKeys() {
        return HardCases.all(true).stream().map(HardCase::key).toList();
    }

    /** Runs the cells one after the other, so that each has the machine to itself; the same settings give the same cells. */
    public static StabilityStudy of(Settings settings, StudyProgress progress) {
        List<HardCase> cases = HardCases.all(settings.quick()).stream()
                .filter(c -> settings.only().isEmpty() || settings.only().contains(c.key()))
                .toList();
        List<Cell> cells = new ArrayList<>();
        int total = cases.size() * settings.kinds().size();
        for (HardCase hard : cases) {
            double duration = settings.quick() ? hard.quickS() : hard.durationS();
            TrustedRun trusted = TrustedRun.of(hard, duration, CellRun.SAMPLE_S);
            for (IntegratorKind kind : settings.kinds()) {
                Cell cell = CellRun.of(hard, kind, trusted, duration, settings.nodeEvaluations());
                cells.add(cell);
                progress.done(
                        cells.size(),
                        total,
                        hard.key() + ", " + kind.label() + ": " + cell.verdict().label()
                                + (cell.sentence().isEmpty() ? "" : " (" + cell.sentence() + ")"));
            }
        }
        return new StabilityStudy(
                cases.stream().map(HardCase::key).toList(),
                cases.stream().map(HardCase::title).toList(),
                settings.kinds(),
                cells);
    }

    /** Whether no cell failed in silence. */
    public boolean passes() {
        return cells.stream().noneMatch(c -> c.verdict() == Verdict.SILENT_FAILURE);
    }
}
