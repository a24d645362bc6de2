package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.Numbers;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.scenario.Scenario;

/** Fits of {@link SyntheticPatient synthetic patients}. The study compares the fitted breath with the known one. */
public record SyntheticStudy(List<Case> cases) {
    /** Columns of {@link #cells}. */
    public static final List<Column> COLUMNS =
            Column.list("patient | # initial | # residual | # residual / initial | # bases, initial"
                    + " | # bases, residual | # floor of the noise | # dome right, true | # fitted"
                    + " | # dome left, true | # fitted | # breaths");

    private static final double NOISE_MM = 1;

    /** A patient with the known breath and the result of the fit. */
    public record Case(SyntheticPatient patient, GroundTruth truth, FitResult result) {
        /** Mean initial distance of the whole lungs, or of their bases only, mm. */
        public double initialMm(boolean bases) {
            return mean(bases, t -> t.initial().mean());
        }

        /** Mean residual distance of the whole lungs, or of their bases only, mm. */
        public double residualMm(boolean bases) {
            return mean(bases, t -> t.residual().mean());
        }

        private double mean(boolean bases, ToDoubleFunction<FitResult.TargetResult> of) {
            return result.targets().stream()
                    .filter(t -> t.target().part().isBase() == bases)
                    .mapToDouble(of)
                    .average()
                    .orElse(Double.NaN);
        }

        private double ratio() {
            return residualMm(false) / initialMm(false);
        }

        /** Error of the fitted height of the right dome, mm: fitted minus true value. */
        public double domeRightErrorMm() {
            return result.observed().get("dome_right_mm") - truth.domeRightMm();
        }

        /** Error of the fitted height of the left dome, mm: fitted minus true value. */
        public double domeLeftErrorMm() {
            return result.observed().get("dome_left_mm") - truth.domeLeftMm();
        }
    }

    /**
     * Fits the first {@code count} of the five patients.
     *
     * @param count number of patients
     * @param resolution resolution of the fitted bodies; the ground truth uses the next finer one, or medium if there
     *     is none
     * @param threads number of parallel simulations
     * @param search settings of each fit; their seed is also used for the noise
     * @param folder folder for the journals
     */
    public static SyntheticStudy run(
            int count,
            Resolution resolution,
            int threads,
            FitSearch.Settings search,
            Path folder,
            FitProgress progress) {
        List<Case> cases = new ArrayList<>();
        for (SyntheticPatient patient : SyntheticPatient.five().subList(0, count)) {
            int number = cases.size() + 1;
            progress.note(number + " of " + count + ": " + patient.name());
            Resolution other = resolution == Resolution.MEDIUM ? Resolution.HIGH : Resolution.MEDIUM;
            GroundTruth truth = GroundTruth.of(patient, other, NOISE_MM, search.seed());
            Scenario base = Scenario.defaults()
                    .with(
                            "preset=deep",
                            "anatomy=" + patient.anatomy(),
                            "resolution=" + resolution.name().toLowerCase(Locale.ROOT));
            FitSetup setup = new FitSetup(
                    base,
                    patient.body(resolution),
                    FitTarget.withBases(truth.targets()),
                    FitParameter.defaults(base),
                    new FitSetup.Options(
                            FitHalf.ALL, "none: both levels are of one body in one place", search, threads, false));
            FitResult result = Fit.run(setup, folder.resolve("journal-" + number + ".csv"), progress);
            cases.add(new Case(patient, truth, result));
        }
        return new SyntheticStudy(cases);
    }

    /** The patients whose fitted breath their scenario does not give again, as a sentence; empty if there are none. */
    public Optional<String> failure() {
        String names = cases.stream()
                .filter(c -> !c.result.reproduced())
                .map(c -> c.patient.name())
                .collect(Collectors.joining(", "));
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of("Scenarios that were run and do NOT give the fitted state: " + names + ".");
    }

    /** Table cells, mm, one row per patient. */
    public List<List<String>> cells() {
        return cases.stream().map(SyntheticStudy::row).toList();
    }

    private static List<String> row(Case c) {
        return List.of(
                c.patient.name(),
                FitReport.mm(c.initialMm(false)),
                FitReport.mm(c.residualMm(false)),
                Numbers.format("%.3f", c.ratio()),
                FitReport.mm(c.initialMm(true)),
                FitReport.mm(c.residualMm(true)),
                FitReport.mm(c.truth.floorMm()),
                FitReport.mm(c.truth.domeRightMm()),
                FitReport.mm(c.result.observed().get("dome_right_mm")),
                FitReport.mm(c.truth.domeLeftMm()),
                FitReport.mm(c.result.observed().get("dome_left_mm")),
                Integer.toString(c.result.search().trials().length));
    }

    /** @param provenance how it was made, one point a line */
    public ReportDocument document(List<String> provenance) {
        ReportDocument page = new ReportDocument(
                "Fits to known breaths",
                "Virtual patients breathe in with hidden settings; what a scan would show of their lungs, with noise of"
                        + " 1 mm, is fitted by another mesh with another tendon and sternum.");
        page.points(provenance.toArray(String[]::new));
        failure().ifPresent(page::paragraph);
        page.table("Mean distance of both lungs, both ways by area, and height of the domes, mm.", COLUMNS, cells());
        for (Case c : cases) {
            page.section(c.patient.name());
            page.paragraph("Hidden: " + String.join(", ", c.patient.hidden()) + ".");
            page.table("", FitReport.PARAMETERS, new FitReport(c.result).parameters());
        }
        return page;
    }

    /** The study as JSON values. */
    public Map<String, Object> values() {
        return new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with("noise_mm", NOISE_MM)
                .with("patients", cases.stream().map(SyntheticStudy::values).toList());
    }

    private static OrderedValues values(Case c) {
        return new OrderedValues()
                .with("patient", c.patient.name())
                .with("hidden", c.patient.hidden())
                .with("initial_mm", c.initialMm(false))
                .with("residual_mm", c.residualMm(false))
                .with("ratio", FitReport.finite(c.ratio()))
                .with("floor_mm", c.truth.floorMm())
                .with("true_dome_right_mm", c.truth.domeRightMm())
                .with("true_dome_left_mm", c.truth.domeLeftMm())
                .with("dome_right_error_mm", c.domeRightErrorMm())
                .with("dome_left_error_mm", c.domeLeftErrorMm())
                .with("fit", new FitReport(c.result).values());
    }
}
