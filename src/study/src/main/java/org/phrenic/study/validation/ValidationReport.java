package org.phrenic.study.validation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.study.validation.Finding.Verdict;

/** A validation as Markdown and as values for JSON; the same validation gives the same text. */
public final class ValidationReport {
    private static final String NOTICE = org.phrenic.document.report.Disclaimer.TEXT;

    private final Validation validation;

    public ValidationReport(Validation validation) {
        this.validation = validation;
    }

    /** How many findings of a body have this verdict and confidence. */
    private static long count(Validation.Body body, Confidence confidence, Verdict verdict) {
        return body.findings().stream()
                .filter(f -> f.range().confidence() == confidence && f.verdict() == verdict)
                .count();
    }

    /** A number with as many places as its size asks for. */
    public static String number(double value) {
        if (!Double.isFinite(value)) {
            return "";
        }
        double size = Math.abs(value);
        String text = String.format(Locale.ROOT, size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : "%.2f", value);
        return text.matches("-0(\\.0+)?") ? text.substring(1) : text;
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

    /** How a row is measured: "fall of dome_right_mm". */
    public static String measurement(ReferenceRange row) {
        if (row.preset().isEmpty()) {
            return "-";
        }
        String what = row.reduction().label() + " of " + String.join(", ", row.observables());
        String against = row.against().isEmpty()
                ? ""
                : (row.reduction() == Reduction.AT_SHARE ? " at " + plain(row.share()) + " of " : " by ")
                        + row.against();
        return what + against + row.againstPreset().map(p -> " (" + p + ")").orElse("");
    }

    /** One line that sums a body up. */
    public static String summary(Validation.Body body) {
        long within = body.findings().stream()
                .filter(f -> f.verdict() == Verdict.WITHIN)
                .count();
        long out =
                body.findings().stream().filter(f -> f.verdict() == Verdict.OUT).count();
        long misses = body.findings().stream().filter(Finding::isMiss).count();
        return body.anatomy() + ": " + within + " within, " + out + " out (" + misses + " of these S or R+), "
                + (body.findings().size() - within - out) + " not measurable here";
    }

    /** The whole report as Markdown. */
    public String markdown() {
        StringBuilder text = new StringBuilder("# Validation against physiology\n\n");
        text.append("Table `").append(validation.table().name()).append("`, ");
        text.append(validation.settings().resolution().name().toLowerCase(Locale.ROOT))
                .append(" resolution. ");
        text.append("Verdict: **")
                .append(validation.passes() ? "passed" : "failed")
                .append("** (a range of confidence S or R+ that is missed fails).\n");
        text.append(NOTICE).append('\n');
        for (Validation.Body body : validation.bodies()) {
            text.append("\n## ").append(body.anatomy()).append("\n\n");
            text.append(summary(body)).append(".\n\n");
            text.append("| quantity | preset | value | range | unit | confidence | verdict | measured | source |\n");
            text.append("|---|---|---|---|---|---|---|---|---|\n");
            for (Finding f : body.findings()) {
                text.append(line(f));
            }
            text.append("\n| confidence | within | out | not measurable here |\n|---|---|---|---|\n");
            for (Confidence c : Confidence.values()) {
                text.append("| ")
                        .append(c.tag())
                        .append(" (")
                        .append(c.meaning())
                        .append(") |");
                for (Verdict v : Verdict.values()) {
                    text.append(' ').append(count(body, c, v)).append(" |");
                }
                text.append('\n');
            }
        }
        return text.toString();
    }

    private static String line(Finding f) {
        ReferenceRange row = f.range();
        String verdict = f.isMiss() ? "**out**" : f.verdict().label();
        String reason = f.reason().isEmpty() ? "" : ": " + f.reason().replace("|", "/");
        String note = row.note().isEmpty() || row.preset().isEmpty() ? "" : " (" + row.note() + ")";
        return "| "
                + String.join(
                        " | ",
                        row.key(),
                        row.preset().orElse("-"),
                        number(f.value()),
                        range(row),
                        row.unit(),
                        row.confidence().tag(),
                        verdict + reason,
                        measurement(row),
                        (row.source() + note).replace("|", "/"))
                + " |\n";
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", NOTICE);
        map.put("table", validation.table().name());
        map.put("passes", validation.passes());
        map.put("settings", validation.settings().toMap());
        List<Object> bodies = new ArrayList<>();
        for (Validation.Body body : validation.bodies()) {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("anatomy", body.anatomy());
            each.put("name", body.name());
            body.sex().ifPresent(sex -> each.put("sex", sex));
            Map<String, Object> totals = new LinkedHashMap<>();
            for (Confidence c : Confidence.values()) {
                Map<String, Object> of = new LinkedHashMap<>();
                for (Verdict v : Verdict.values()) {
                    of.put(v.name().toLowerCase(Locale.ROOT), count(body, c, v));
                }
                totals.put(c.tag(), of);
            }
            each.put("totals", totals);
            each.put(
                    "rows",
                    body.findings().stream().map(ValidationReport::values).toList());
            bodies.add(each);
        }
        map.put("bodies", bodies);
        return map;
    }

    private static Map<String, Object> values(Finding f) {
        ReferenceRange row = f.range();
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("key", row.key());
        row.preset().ifPresent(p -> map.put("preset", p));
        map.put("verdict", f.verdict().name().toLowerCase(Locale.ROOT));
        put(map, "value", f.value());
        put(map, "low", row.low());
        put(map, "high", row.high());
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
        return map;
    }

    private static void put(Map<String, Object> map, String key, double value) {
        if (Double.isFinite(value)) {
            map.put(key, value);
        }
    }
}
