package org.phrenic.study.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Stream;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.Numbers;
import org.phrenic.fit.FitReport;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.LandmarkTable;
import org.phrenic.study.Attempts;
import org.phrenic.study.ReportNumbers;

/**
 * Fits of patients and of known breaths as a report and as values for JSON.
 *
 * @param failures patients that were not fitted, each with the reason
 */
public record FitStudyReport(List<PatientFit> patients, List<KnownBreath> known, List<String> failures) {
    private static final List<Column> SURFACES =
            Column.list("patient | fitted to | # breaths | # before mm | # after mm | # ratio | # held out: ratio");
    private static final List<Column> KNOWN = Column.list(
            "body | known breath | # breaths | # failed | # before mm | # after mm | # ratio | without a result");

    public FitStudyReport {
        patients = List.copyOf(patients);
        known = List.copyOf(known);
        failures = List.copyOf(failures);
    }

    /** Whether every patient was fitted and every fit has a result, which its scenario gives again. */
    public boolean passes() {
        return failures.isEmpty() && known.stream().allMatch(k -> k.result().isPresent()) && notReproduced() == 0;
    }

    private long notReproduced() {
        return Stream.concat(
                        patients.stream().flatMap(p -> Stream.of(p.whole(), p.even(), p.odd())),
                        known.stream().flatMap(k -> k.result().stream()))
                .filter(fit -> !fit.reproduced())
                .count();
    }

    /** One-line summary. */
    public String summary() {
        long without = known.stream().filter(k -> k.result().isEmpty()).count();
        long other = notReproduced();
        return patients.size() + " patients fitted, " + (failures.isEmpty() ? "" : failures.size() + " not fitted, ")
                + known.size() + " known breaths, " + without
                + " of them without a result"
                + (other == 0 ? "" : ", " + other + " fits whose scenario gives another state");
    }

    /** @param provenance how the report was made, one point a line */
    public ReportDocument document(List<String> provenance) {
        ReportDocument page = new ReportDocument("Fits to a second breath level", summary() + ".");
        page.points(provenance.toArray(String[]::new));
        Attempts.addFailures(page, "Not fitted", failures);
        if (!patients.isEmpty()) {
            page.section("Surfaces");
            page.paragraph("Mean distance on all targets (whole lungs and bases, both sides, equal weights). Half:"
                    + " every other square of 40 mm seen from above; held out: mean distance on the other squares,"
                    + " after over before.");
            page.table("", SURFACES, surfaces());
        }
        for (PatientFit patient : patients) {
            page.section(patient.name());
            page.paragraph(patient.whole().setup().options().alignment() + ".");
            page.table("", FitReport.DISTANCES, report(patient).distances());
            patient.whole().landmarks().ifPresent(errors -> {
                LandmarkTable table = new LandmarkTable(errors);
                page.paragraph(table.shifts());
                page.table("", LandmarkTable.COLUMNS, table.rows());
            });
            if (!report(patient).limits().isEmpty()) {
                page.points(report(patient).limits().toArray(String[]::new));
            }
        }
        if (!known.isEmpty()) {
            page.section("Known breaths of random bodies");
            page.table("", KNOWN, known.stream().map(FitStudyReport::row).toList());
        }
        return page;
    }

    private static FitReport report(PatientFit patient) {
        return new FitReport(patient.whole());
    }

    /** One row for each fit of a patient. */
    public List<List<String>> surfaces() {
        List<List<String>> rows = new ArrayList<>();
        for (PatientFit p : patients) {
            rows.add(row(p.name(), "whole", p.whole(), ""));
            rows.add(row("", "one half", p.even(), ratio(PatientFit.heldOutRatio(p.even()))));
            rows.add(row("", "other half", p.odd(), ratio(PatientFit.heldOutRatio(p.odd()))));
        }
        return rows;
    }

    private static List<String> row(String name, String half, FitResult fit, String heldOut) {
        return List.of(
                name,
                half,
                Integer.toString(fit.search().trials().length),
                ReportNumbers.number(fit.initialMm()),
                ReportNumbers.number(fit.bestMm()),
                ratio(fit.ratio()),
                heldOut);
    }

    private static List<String> row(KnownBreath k) {
        Function<Function<FitResult, String>, String> cell =
                of -> k.result().map(of).orElse("");
        return List.of(
                k.body(),
                String.join(", ", k.hidden()),
                cell.apply(r -> Integer.toString(r.search().trials().length)),
                cell.apply(r -> Integer.toString(
                        r.search().failures().stream().mapToInt(f -> f.count()).sum())),
                cell.apply(r -> ReportNumbers.number(r.initialMm())),
                cell.apply(r -> ReportNumbers.number(r.bestMm())),
                cell.apply(r -> ratio(r.ratio())),
                k.failure());
    }

    private static String ratio(double value) {
        return Numbers.format("%.3f", value);
    }

    /** The study as JSON values. */
    public Map<String, Object> values() {
        return new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with(
                        "patients",
                        patients.stream()
                                .map(p -> new OrderedValues()
                                        .with("name", p.name())
                                        .with("fit", report(p).values())
                                        .with("held_out_ratio", FitReport.finite(PatientFit.heldOutRatio(p.even())))
                                        .with(
                                                "held_out_ratio_of_the_other_half",
                                                FitReport.finite(PatientFit.heldOutRatio(p.odd()))))
                                .toList())
                .with("not_fitted", failures)
                .with(
                        "known_breaths",
                        known.stream()
                                .map(k -> new OrderedValues()
                                        .with("body", k.body())
                                        .with("hidden", k.hidden())
                                        .with(
                                                "ratio",
                                                k.result()
                                                        .map(r -> FitReport.finite(r.ratio()))
                                                        .orElse(null))
                                        .with("failure", k.failure()))
                                .toList());
    }
}
