package org.phrenic.study.validation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.RunSettings;
import org.phrenic.study.Attempts;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.validation.Finding.Verdict;

/** A validation as Markdown and as values for JSON. The output is deterministic. */
public record ValidationReport(Validation validation) {
    private static final List<Column> COLUMNS = Stream.of(
                    "quantity preset value range unit confidence verdict measured source".split(" "))
            .map(name -> new Column(name, name.equals("value") || name.equals("range")))
            .toList();

    private static long count(Validation.Body body, Confidence confidence, Verdict verdict) {
        return body.findings().stream()
                .filter(f -> f.range().confidence() == confidence && f.verdict() == verdict)
                .count();
    }

    /** A range: "12 - 24", "at least 10", "at most 0.33". */
    public static String range(ReferenceRange row) {
        if (Double.isNaN(row.low())) {
            return "at most " + plain(row.high());
        }
        return Double.isNaN(row.high()) ? "at least " + plain(row.low()) : plain(row.low()) + " - " + plain(row.high());
    }

    private static String plain(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /** How a quantity is measured: "fall of dome_right_mm". */
    public static String measurement(ReferenceRange row) {
        if (row.preset().isEmpty()) {
            return "-";
        }
        String what = row.reduction().label() + " of " + String.join(", ", row.observables());
        String by = row.reduction() == Reduction.AT_SHARE ? " at " + plain(row.share()) + " of " : " by ";
        return what
                + (row.against().isEmpty() ? "" : by + row.against())
                + row.againstPreset().map(p -> " (" + p + ")").orElse("");
    }

    /** One-line summary of a body. */
    public static String summary(Validation.Body body) {
        long within = body.count(Verdict.WITHIN);
        long out = body.count(Verdict.OUT);
        long misses = body.findings().stream().filter(Finding::isMiss).count();
        return RunSettings.bodyLabel(body.anatomy()) + ": " + within + " within, " + out + " out (" + misses
                + " of these S or R+), " + body.count(Verdict.NOT_MEASURABLE) + " not measurable here";
    }

    /**
     * The whole report.
     *
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument(
                "Validation against physiology",
                "Table " + validation.table().name() + ", "
                        + ReportNumbers.label(validation.settings().resolution()) + " resolution. Verdict: "
                        + (validation.passes() ? "passed" : "failed")
                        + " (a range of confidence S or R+ that is missed fails).");
        report.points(provenance.toArray(String[]::new));
        Attempts.addFailures(report, "Not computed", validation.failures());
        List<Column> totals = Stream.concat(
                        Stream.of(Column.text("confidence")),
                        Arrays.stream(Verdict.values()).map(v -> Column.number(v.label())))
                .toList();
        for (Validation.Body body : validation.bodies()) {
            report.section(RunSettings.bodyLabel(body.anatomy()));
            report.paragraph(summary(body) + ".");
            report.table(
                    "",
                    COLUMNS,
                    body.findings().stream().map(ValidationReport::cells).toList());
            report.table(
                    "",
                    totals,
                    Arrays.stream(Confidence.values()).map(c -> cells(body, c)).toList());
        }
        return report;
    }

    private static List<String> cells(Validation.Body body, Confidence confidence) {
        List<String> cells = new ArrayList<>(List.of(confidence.tag() + " (" + confidence.meaning() + ")"));
        Arrays.stream(Verdict.values()).forEach(v -> cells.add(Long.toString(count(body, confidence, v))));
        return cells;
    }

    private static List<String> cells(Finding f) {
        ReferenceRange row = f.range();
        String verdict = f.isMiss() ? "OUT" : f.verdict().label();
        boolean hasNote = !row.note().isEmpty() && row.preset().isPresent();
        return List.of(
                row.key(),
                row.preset().orElse("-"),
                ReportNumbers.number(f.value()),
                range(row),
                row.unit(),
                row.confidence().tag(),
                f.reason().isEmpty() ? verdict : verdict + ": " + f.reason(),
                measurement(row),
                hasNote ? row.source() + " (" + row.note() + ")" : row.source());
    }

    /** The validation as values for JSON. */
    public Map<String, Object> values() {
        return new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with("table", validation.table().name())
                .with("passes", validation.passes())
                .with("failures", validation.failures())
                .with("settings", validation.settings().toMap())
                .with(
                        "bodies",
                        validation.bodies().stream()
                                .map(ValidationReport::values)
                                .toList());
    }

    private static Map<String, Object> values(Validation.Body body) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("anatomy", body.anatomy());
        map.put("name", body.name());
        body.sex().ifPresent(sex -> map.put("sex", sex));
        Map<String, Object> totals = new LinkedHashMap<>();
        for (Confidence c : Confidence.values()) {
            Map<String, Object> of = new LinkedHashMap<>();
            Arrays.stream(Verdict.values()).forEach(v -> of.put(ReportNumbers.label(v), count(body, c, v)));
            totals.put(c.tag(), of);
        }
        map.put("totals", totals);
        map.put("rows", body.findings().stream().map(ValidationReport::values).toList());
        return map;
    }

    private static Map<String, Object> values(Finding f) {
        ReferenceRange row = f.range();
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("key", row.key());
        row.preset().ifPresent(p -> map.put("preset", p));
        map.put("verdict", ReportNumbers.label(f.verdict()));
        map.put("value", f.value());
        map.put("low", row.low());
        map.put("high", row.high());
        map.put("unit", row.unit());
        map.put("confidence", row.confidence().tag());
        map.put("measured", measurement(row));
        map.put("source", row.source());
        boolean out = f.verdict() == Verdict.OUT;
        if (out) {
            map.put("missed_because", f.reason());
        }
        String note = f.reason().isEmpty() || out ? row.note() : f.reason();
        if (!note.isEmpty()) {
            map.put("note", note);
        }
        map.values().removeIf(value -> value instanceof Double number && !Double.isFinite(number));
        return map;
    }
}
