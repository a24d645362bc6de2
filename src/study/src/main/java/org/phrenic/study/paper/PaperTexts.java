package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.study.paper.Claim.Verdict;

/**
 * Claims, tables and texts of the report ({@code data/paper/report.yaml}), with placeholders {0}, {1} ... for results.
 */
final class PaperTexts {
    private record ClaimText(String key, String statement, String published, String explanation) {}

    private record Row(List<String> cells) {}

    private record Table(String key, List<Row> rows) {}

    private record Text(String key, String text) {}

    private record Report(List<ClaimText> claims, List<Table> tables, List<Text> texts) {}

    private static final Report REPORT = ShippedFile.yaml("paper/report.yaml").bind(Report.class);

    private static final Map<String, ClaimText> CLAIMS = byKey(REPORT.claims, ClaimText::key);
    private static final Map<String, Table> TABLES = byKey(REPORT.tables, Table::key);
    private static final Map<String, Text> TEXTS = byKey(REPORT.texts, Text::key);

    private PaperTexts() {}

    private static <T> Map<String, T> byKey(List<T> items, Function<T, String> key) {
        return items.stream().collect(Collectors.toMap(key, Function.identity()));
    }

    private static String filled(String text, Object... values) {
        String result = text;
        for (int i = 0; i < values.length; i++) {
            result = result.replace("{" + i + "}", String.valueOf(values[i]));
        }
        return result;
    }

    /** @param values for the placeholders of the published text and the explanation */
    static Claim claim(String key, Verdict verdict, String measured, Object... values) {
        ClaimText text = CLAIMS.get(key);
        return new Claim(
                text.statement, filled(text.published, values), measured, verdict, filled(text.explanation, values));
    }

    /** A claim that is omitted in a short reproduction. */
    static Claim notMeasured(String key, Object... values) {
        ClaimText text = CLAIMS.get(key);
        String reason = "Its breath was left out of a quick reproduction, or failed.";
        return new Claim(text.statement, filled(text.published, values), "-", Verdict.NOT_MEASURED, reason);
    }

    static List<List<String>> rows(String table, Object... values) {
        List<List<String>> rows = new ArrayList<>();
        TABLES.get(table)
                .rows
                .forEach(row -> rows.add(
                        row.cells.stream().map(cell -> filled(cell, values)).toList()));
        return rows;
    }

    static String text(String key, Object... values) {
        return filled(TEXTS.get(key).text, values);
    }

    /** Text columns, then number columns. */
    static List<Column> columns(int texts, String... headings) {
        List<Column> columns =
                new ArrayList<>(Arrays.stream(headings).map(Column::number).toList());
        columns.subList(0, texts).replaceAll(column -> Column.text(column.heading()));
        return columns;
    }
}
