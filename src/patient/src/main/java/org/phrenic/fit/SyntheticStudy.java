package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.scenario.Scenario;

/** Fits bodies to breaths that are known: what a fit recovers, and what it leaves. */
public final class SyntheticStudy {
    /** Columns of {@link #cells}. */
    public static final List<Column> COLUMNS = List.of(
            Column.text("patient"),
            Column.number("initial"),
            Column.number("residual"),
            Column.number("residual / initial"),
            Column.number("bases, initial"),
            Column.number("bases, residual"),
            Column.number("floor of the noise"),
            Column.number("dome right, true"),
            Column.number("fitted"),
            Column.number("dome left, true"),
            Column.number("fitted"),
            Column.number("breaths"));

    private static final double NOISE_MM = 1;

    /**
     * A patient.
     *
     * @param patient who
     * @param truth what was to be found
     * @param result what was found
     */
    public record Case(SyntheticPatient patient, GroundTruth truth, FitResult result) {
        /** Mean distance at rest of the whole lungs, or of their bases, mm. */
        public double initialMm(boolean bases) {
            return mean(bases, t -> t.initial().mean());
        }

        /** The same of the body as fitted. */
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

        /** Height of the right dome as fitted less the true one, mm. */
        public double domeRightErrorMm() {
            return result.observed().get("dome_right_mm") - truth.domeRightMm();
        }

        /** The same of the left dome. */
        public double domeLeftErrorMm() {
            return result.observed().get("dome_left_mm") - truth.domeLeftMm();
        }
    }

    private final List<Case> cases = new ArrayList<>();

    /**
     * Fits the first of the five patients.
     *
     * @param count how many
     * @param resolution of the bodies that are fitted; the truth has the next finer one, or medium where that is the
     *     finest
     * @param threads breaths side by side
     * @param evaluations of each fit
     * @param seed of the search and the noise
     * @param folder for the journals; what they hold is not breathed again
     */
    public static SyntheticStudy run(
            int count,
            Resolution resolution,
            int threads,
            int evaluations,
            long seed,
            Path folder,
            FitProgress progress) {
        SyntheticStudy study = new SyntheticStudy();
        List<SyntheticPatient> five = SyntheticPatient.five();
        for (int i = 0; i < count; i++) {
            SyntheticPatient patient = five.get(i);
            progress.note((i + 1) + " of " + count + ": " + patient.name());
            GroundTruth truth = GroundTruth.of(patient, other(resolution), NOISE_MM, seed);
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
                    false,
                    "none: both levels are of one body in one place",
                    seed,
                    0,
                    FitSetup.SIGMA,
                    threads,
                    evaluations,
                    Double.POSITIVE_INFINITY,
                    false);
            FitResult result = Fit.run(setup, folder.resolve("journal-" + (i + 1) + ".csv"), progress);
            study.cases.add(new Case(patient, truth, result));
        }
        return study;
    }

    private static Resolution other(Resolution resolution) {
        return switch (resolution) {
            case LOW, HIGH -> Resolution.MEDIUM;
            case MEDIUM -> Resolution.HIGH;
        };
    }

    /** One a patient. */
    public List<Case> cases() {
        return List.copyOf(cases);
    }

    /** A row a patient, mm. */
    public List<List<String>> cells() {
        return cases.stream()
                .map(c -> List.of(
                        c.patient().name(),
                        mm(c.initialMm(false)),
                        mm(c.residualMm(false)),
                        String.format(Locale.ROOT, "%.3f", c.residualMm(false) / c.initialMm(false)),
                        mm(c.initialMm(true)),
                        mm(c.residualMm(true)),
                        mm(c.truth().floorMm()),
                        mm(c.truth().domeRightMm()),
                        mm(c.result().observed().get("dome_right_mm")),
                        mm(c.truth().domeLeftMm()),
                        mm(c.result().observed().get("dome_left_mm")),
                        Integer.toString(c.result().trials().length)))
                .toList();
    }

    /** All of it, to be written as a page. */
    public ReportDocument document() {
        ReportDocument page = new ReportDocument(
                "Fits to known breaths",
                "Virtual patients breathe in with hidden settings; what a scan would show of their lungs, with noise of 1 mm, is fitted by another mesh with another tendon and sternum.");
        page.table("Mean distance of both lungs, both ways by area, and height of the domes, mm.", COLUMNS, cells());
        for (Case c : cases) {
            page.section(c.patient().name());
            page.paragraph("Hidden: " + String.join(", ", c.patient().hidden()) + ".");
            page.table("", FitReport.PARAMETERS, new FitReport(c.result()).parameters());
        }
        return page;
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("noise_mm", NOISE_MM);
        List<Object> rows = new ArrayList<>();
        for (Case c : cases) {
            Map<String, Object> row = new LinkedHashMap<>();
            row.put("patient", c.patient().name());
            row.put("hidden", c.patient().hidden());
            row.put("initial_mm", c.initialMm(false));
            row.put("residual_mm", c.residualMm(false));
            row.put("ratio", c.residualMm(false) / c.initialMm(false));
            row.put("floor_mm", c.truth().floorMm());
            row.put("true_dome_right_mm", c.truth().domeRightMm());
            row.put("true_dome_left_mm", c.truth().domeLeftMm());
            row.put("dome_right_error_mm", c.domeRightErrorMm());
            row.put("dome_left_error_mm", c.domeLeftErrorMm());
            row.put("fit", new FitReport(c.result()).values());
            rows.add(row);
        }
        map.put("patients", rows);
        return map;
    }

    private static String mm(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }
}
