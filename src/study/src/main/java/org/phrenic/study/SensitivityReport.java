package org.phrenic.study;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.RunSettings;

/** A sensitivity study as Markdown and as values for JSON. */
public record SensitivityReport(Sensitivity sensitivity) {

    /** Table cells with header: the parameter, then per cent per per cent for each observable. */
    public List<List<String>> cells() {
        List<List<String>> table = new ArrayList<>();
        List<String> header = new ArrayList<>(List.of("parameter"));
        header.addAll(sensitivity.observables());
        table.add(header);
        for (Sensitivity.Row row : sensitivity.rows()) {
            List<String> line = new ArrayList<>(List.of(row.parameter().key()));
            for (double effect : row.effects()) {
                line.add(Double.isNaN(effect) ? "-" : signed(effect));
            }
            table.add(line);
        }
        return table;
    }

    private static String signed(double effect) {
        String text = format("%+.2f", effect);
        return text.matches("[+-]0\\.00") ? "0.00" : text;
    }

    /** Whether every breath was computed. */
    public boolean isComplete() {
        return sensitivity.failures().isEmpty();
    }

    /**
     * The table as a document.
     *
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument(
                "Which parameter moves which observable",
                "Change of the observable in per cent for one per cent of the parameter, each parameter alone between"
                        + " nine and eleven tenths of its value (or to the end of its range); preset "
                        + sensitivity.preset() + ", " + RunSettings.bodyLabel(sensitivity.anatomy())
                        + ". A parameter whose value is 0 has no per cent and is left out.");
        report.points(provenance.toArray(String[]::new));
        Attempts.addFailures(report, "Not computed", sensitivity.failures());
        List<List<String>> cells = cells();
        List<Column> columns =
                new ArrayList<>(cells.get(0).stream().map(Column::number).toList());
        columns.set(0, Column.text("parameter"));
        return report.table("", columns, cells.subList(1, cells.size()));
    }

    /** The study as values for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("preset", sensitivity.preset());
        map.put("anatomy", sensitivity.anatomy());
        map.put("failures", sensitivity.failures());
        map.put("reference", named(sensitivity.reference()));
        Map<String, Object> rows = new LinkedHashMap<>();
        for (Sensitivity.Row row : sensitivity.rows()) {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("from", row.from());
            each.put("to", row.to());
            each.put("percent_per_percent", named(row.effects()));
            rows.put(row.parameter().key(), each);
        }
        map.put("parameters", rows);
        return map;
    }

    private Map<String, Object> named(double[] values) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int i = 0; i < values.length; i++) {
            if (!Double.isNaN(values[i])) {
                map.put(sensitivity.observables().get(i), values[i]);
            }
        }
        return map;
    }
}
