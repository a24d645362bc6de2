package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.document.CsvWriter;
import org.phrenic.engine.integrator.IntegratorKind;

/** A stability study as Markdown, as CSV and as values for JSON; the same study gives the same text. */
public final class StabilityReport {
    private static final String NOTICE = "For research and training only. Not for clinical use.";
    private static final List<String> FIGURES = List.of(
            "simulated_s",
            "time_step_s",
            "kinetic_factor",
            "speed_mm_s",
            "reach_mm",
            "shape",
            "link_error",
            "return_mm",
            "repeat_mm",
            "drift_mm");

    private final StabilityStudy study;

    public StabilityReport(StabilityStudy study) {
        this.study = study;
    }

    private CaseResult cell(String key, IntegratorKind kind) {
        return study.cells().stream()
                .filter(c -> c.caseKey().equals(key) && c.integrator() == kind)
                .findFirst()
                .orElseThrow();
    }

    /** How many cells ended in each way: "120 stable, 6 recovered, ...". */
    public String summary() {
        return Arrays.stream(CaseOutcome.values())
                .map(v -> study.cells().stream().filter(c -> c.outcome() == v).count() + " " + v.label())
                .collect(Collectors.joining(", "));
    }

    /**
     * A row a case, a column an integrator: the verdicts, with the simulated time where the cell ended before that of
     * the case.
     */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        List<String> header = new ArrayList<>(List.of("case"));
        study.integrators().forEach(kind -> header.add(kind.label()));
        rows.add(header);
        for (String key : study.keys()) {
            List<String> row = new ArrayList<>(List.of(key));
            for (IntegratorKind kind : study.integrators()) {
                CaseResult c = cell(key, kind);
                row.add(c.outcome().label()
                        + (c.endedEarly() ? String.format(Locale.ROOT, " (%.3g s)", c.simulatedS()) : ""));
            }
            rows.add(row);
        }
        return rows;
    }

    /** The whole report as Markdown. */
    public String markdown() {
        StringBuilder text = new StringBuilder("# Stability on hard cases\n\n");
        text.append(summary()).append(". ").append(NOTICE).append("\n\n");
        text.append("A time in brackets: the cell spent what it may and ended there.\n\n");
        List<List<String>> table = table();
        for (int r = 0; r < table.size(); r++) {
            text.append("| ").append(String.join(" | ", table.get(r))).append(" |\n");
            if (r == 0) {
                text.append("|---".repeat(table.get(0).size())).append("|\n");
            }
        }
        text.append("\n## What was seen\n\n| case | what is hard | s |\n|---|---|---|\n");
        for (int i = 0; i < study.keys().size(); i++) {
            text.append(String.format(
                    Locale.ROOT,
                    "| %s | %s | %.4g |%n",
                    study.keys().get(i),
                    study.titles().get(i),
                    cell(study.keys().get(i), study.integrators().get(0)).requestedS()));
        }
        text.append(
                "\n| case | integrator | verdict | substeps | kinetic | mm/s | reach mm | shape | links |"
                        + " return mm | repeat mm | drift mm | sentence |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
        for (CaseResult c : study.cells()) {
            text.append("| ")
                    .append(String.join(
                            " | ",
                            c.caseKey(),
                            c.integrator().label(),
                            c.outcome().label(),
                            String.valueOf(c.substeps()),
                            brief(c.kineticFactor()),
                            brief(c.speedMmS()),
                            brief(c.reachMm()),
                            brief(c.shapeError()),
                            brief(c.linkError()),
                            brief(c.returnMm()),
                            brief(c.repeatMm()),
                            brief(c.driftMm()),
                            c.sentence()))
                    .append(" |\n");
        }
        return text.toString().replace("\r\n", "\n");
    }

    private static String brief(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.3g", value);
    }

    /** A line a cell, with all figures. */
    public String csv() {
        List<String> header = new ArrayList<>(List.of("case", "integrator", "verdict"));
        header.addAll(FIGURES);
        header.add("substeps");
        header.add("sentence");
        List<List<String>> rows = new ArrayList<>();
        for (CaseResult c : study.cells()) {
            List<String> row = new ArrayList<>(
                    List.of(c.caseKey(), c.integrator().label(), c.outcome().label()));
            for (double figure : figures(c)) {
                row.add(CsvWriter.number(figure, CsvWriter.ALL_DIGITS));
            }
            row.add(String.valueOf(c.substeps()));
            row.add(c.sentence());
            rows.add(row);
        }
        return CsvWriter.format(header, rows);
    }

    private static double[] figures(CaseResult c) {
        return new double[] {
            c.simulatedS(),
            c.dtS(),
            c.kineticFactor(),
            c.speedMmS(),
            c.reachMm(),
            c.shapeError(),
            c.linkError(),
            c.returnMm(),
            c.repeatMm(),
            c.driftMm()
        };
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", NOTICE);
        map.put("passes", study.passes());
        Map<String, Object> titles = new LinkedHashMap<>();
        for (int i = 0; i < study.keys().size(); i++) {
            titles.put(study.keys().get(i), study.titles().get(i));
        }
        map.put("cases", titles);
        List<Object> cells = new ArrayList<>();
        for (CaseResult c : study.cells()) {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("case", c.caseKey());
            each.put("integrator", c.integrator().label());
            each.put("verdict", c.outcome().label());
            if (!c.sentence().isEmpty()) {
                each.put("sentence", c.sentence());
            }
            double[] figures = figures(c);
            for (int i = 0; i < figures.length; i++) {
                if (Double.isFinite(figures[i])) {
                    each.put(FIGURES.get(i), figures[i]);
                }
            }
            each.put("substeps", c.substeps());
            cells.add(each);
        }
        map.put("cells", cells);
        return map;
    }
}
