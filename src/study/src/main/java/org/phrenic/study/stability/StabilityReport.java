package org.phrenic.study.stability;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.engine.integrator.IntegratorKind;

/** A stability study as Markdown, CSV and values for JSON. The output is deterministic. */
public record StabilityReport(StabilityStudy study) {

    private CaseResult result(String key, IntegratorKind integrator) {
        return study.cells().stream()
                .filter(c -> c.caseKey().equals(key) && c.integrator() == integrator)
                .findFirst()
                .orElseThrow();
    }

    /** Number of cells by outcome, and of those that ended before their time: "120 stable, 6 recovered, ...". */
    public String summary() {
        String outcomes = Arrays.stream(CaseResult.Outcome.values())
                .map(o -> study.cells().stream().filter(c -> c.outcome() == o).count() + " " + o.label())
                .collect(Collectors.joining(", "));
        List<CaseResult> early =
                study.cells().stream().filter(CaseResult::endedEarly).toList();
        if (early.isEmpty()) {
            return outcomes;
        }
        double least = early.stream().mapToDouble(CaseResult::simulatedS).min().orElseThrow();
        return outcomes + format("; %d of them ended before their time, the first after %.3g s", early.size(), least);
    }

    /**
     * Outcomes as a header and one row per case with one column per integrator. The simulated time is given if the cell
     * ended early.
     */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(header());
        for (String key : study.cases().keySet()) {
            List<String> row = new ArrayList<>(List.of(key));
            for (IntegratorKind integrator : study.integrators()) {
                CaseResult c = result(key, integrator);
                row.add(c.outcome().label() + (c.endedEarly() ? format(" (%.3g s)", c.simulatedS()) : ""));
            }
            rows.add(row);
        }
        return rows;
    }

    private List<String> header() {
        return Stream.concat(Stream.of("case"), study.integrators().stream().map(IntegratorKind::label))
                .toList();
    }

    /**
     * The whole report.
     *
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument("Stability on hard cases", summary() + ".");
        report.points(provenance.toArray(String[]::new));
        report.paragraph("A time in brackets: the cell spent the evaluations it may and ended there.");
        List<List<String>> table = table();
        report.table("", header().stream().map(Column::text).toList(), table.subList(1, table.size()));
        report.section("Cells");
        report.table(
                "",
                Column.list("case | what is hard | # s"),
                study.cases().entrySet().stream()
                        .map(e -> List.of(e.getKey(), e.getValue(), requestedS(e.getKey())))
                        .toList());
        List<Column> columns = new ArrayList<>(Column.list("case | integrator | verdict | # substeps"));
        Arrays.stream(StabilityMeasure.values()).forEach(m -> columns.add(Column.number(m.heading())));
        columns.add(Column.text("sentence"));
        report.table(
                "", columns, study.cells().stream().map(StabilityReport::row).toList());
        return report;
    }

    private String requestedS(String key) {
        return format("%.4g", result(key, study.integrators().get(0)).requestedS());
    }

    private static List<String> row(CaseResult c) {
        List<String> row = new ArrayList<>(
                List.of(c.caseKey(), c.integrator().label(), c.outcome().label(), String.valueOf(c.substeps())));
        Arrays.stream(StabilityMeasure.values()).forEach(m -> row.add(brief(c.value(m))));
        row.add(c.sentence());
        return row;
    }

    private static String brief(double value) {
        return Double.isNaN(value) ? "" : format("%.3g", value);
    }

    /** Values of a cell by CSV column and JSON field. */
    private static Map<String, Double> figures(CaseResult c) {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("simulated_s", c.simulatedS());
        figures.put("time_step_s", c.dtS());
        Arrays.stream(StabilityMeasure.values()).forEach(m -> figures.put(m.key(), c.value(m)));
        return figures;
    }

    /** One line per cell with all values. */
    public String csv() {
        List<String> header = new ArrayList<>(List.of("case", "integrator", "verdict", "simulated_s", "time_step_s"));
        Arrays.stream(StabilityMeasure.values()).forEach(m -> header.add(m.key()));
        header.addAll(List.of("substeps", "sentence"));
        List<List<String>> rows = new ArrayList<>();
        for (CaseResult c : study.cells()) {
            List<String> row = new ArrayList<>(
                    List.of(c.caseKey(), c.integrator().label(), c.outcome().label()));
            figures(c).values().forEach(figure -> row.add(CsvWriter.number(figure, CsvWriter.ALL_DIGITS)));
            row.addAll(List.of(String.valueOf(c.substeps()), c.sentence()));
            rows.add(row);
        }
        return CsvWriter.format(header, rows);
    }

    /** The study as values for JSON. */
    public Map<String, Object> values() {
        return new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with("passes", study.passes())
                .with("cases", study.cases())
                .with(
                        "cells",
                        study.cells().stream().map(StabilityReport::values).toList());
    }

    private static Map<String, Object> values(CaseResult c) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("case", c.caseKey());
        map.put("integrator", c.integrator().label());
        map.put("verdict", c.outcome().label());
        if (!c.sentence().isEmpty()) {
            map.put("sentence", c.sentence());
        }
        figures(c).forEach((key, figure) -> {
            if (Double.isFinite(figure)) {
                map.put(key, figure);
            }
        });
        map.put("substeps", c.substeps());
        return map;
    }
}
