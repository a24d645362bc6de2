package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.mesh.query.DistanceSummary;

/** What a fit found as tables, as a document and as values for JSON. */
public final class FitReport {
    /** Columns of {@link #distances}. */
    public static final List<Column> DISTANCES = List.of(
            Column.text("target"),
            Column.text("body"),
            Column.number("mean"),
            Column.number("SD"),
            Column.number("RMS"),
            Column.number("95 %"),
            Column.number("residual / initial"));

    /** Columns of {@link #parameters}. */
    public static final List<Column> PARAMETERS = List.of(
            Column.text("parameter"),
            Column.text("unit"),
            Column.number("bounds"),
            Column.number("start"),
            Column.number("fitted"),
            Column.number("step"),
            Column.number("distance with a step less"),
            Column.number("with a step more"));

    private final FitResult result;

    public FitReport(FitResult result) {
        this.result = result;
    }

    /** Distances before and after, mm, target by target. */
    public List<List<String>> distances() {
        List<List<String>> rows = new ArrayList<>();
        for (FitResult.TargetResult t : result.targets()) {
            String name = t.target().name() + (t.target().weight() > 0 ? "" : " (held out)");
            rows.add(row(name, "at end-expiration", t.initial(), Double.NaN));
            rows.add(row("", "fitted", t.residual(), t.ratio()));
            if (t.residualFitted() != null) {
                rows.add(row("", "fitted, half fitted to", t.residualFitted(), Double.NaN));
                rows.add(row("", "at end-expiration, half held out", t.initialHeldOut(), Double.NaN));
                rows.add(row(
                        "",
                        "fitted, half held out",
                        t.residualHeldOut(),
                        t.residualHeldOut().mean() / t.initialHeldOut().mean()));
            }
        }
        return rows;
    }

    private static List<String> row(String target, String body, FitDistances distances, double ratio) {
        DistanceSummary d = distances.summary();
        return List.of(
                target,
                body,
                mm(d.mean()),
                mm(d.deviation()),
                mm(d.rms()),
                mm(d.percentile95()),
                Double.isNaN(ratio) ? "" : String.format(Locale.ROOT, "%.3f", ratio));
    }

    /** Parameters with what each does, a row each. */
    public List<List<String>> parameters() {
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < result.values().length; i++) {
            FitParameter p = result.setup().parameters().get(i);
            List<String> row = new ArrayList<>(List.of(
                    p.parameter().key(),
                    p.parameter().unit(),
                    number(p.minimum()) + " to " + number(p.maximum()),
                    number(p.start()),
                    number(result.values()[i])));
            if (result.sensitivity().isEmpty()) {
                row.addAll(List.of("", "", ""));
            } else {
                FitResult.Effect e = result.sensitivity().get(i);
                row.add(number(e.step()));
                row.add(Double.isNaN(e.belowMm()) ? "bound" : mm(e.belowMm()));
                row.add(Double.isNaN(e.aboveMm()) ? "bound" : mm(e.aboveMm()));
            }
            rows.add(row);
        }
        return rows;
    }

    /** What was fitted and how it ended, in a sentence or two. */
    public String summary() {
        FitSetup setup = result.setup();
        return String.format(
                Locale.ROOT,
                "The mean distance on what was fitted to fell from %.2f mm (body at end-expiration; %.2f mm breathed in as it was before) to %.2f mm: %.3f of it. %d"
                        + " parameters, %d evaluations in generations of %d, seed %d; it ended because %s. %s",
                result.initialMm(),
                result.untunedMm(),
                result.bestMm(),
                result.ratio(),
                setup.parameters().size(),
                result.trials().length,
                setup.populationSize(),
                setup.seed(),
                result.ended(),
                result.reproduced()
                        ? "scenario.yaml was run and gives the same state bit by bit."
                        : "scenario.yaml was run and does NOT give the same state.");
    }

    /** All of it, to be written as a page. */
    public ReportDocument document(List<Picture> pictures) {
        FitSetup setup = result.setup();
        ReportDocument page = new ReportDocument(
                "Fit to a second breath level",
                "The body " + setup.base().anatomy()
                        + " breathed in and held, with the parameters that bring its surfaces nearest to"
                        + " those given.");
        page.paragraph(summary());
        page.paragraph("Rigid alignment: " + setup.alignment() + ".");
        page.section("Distances");
        page.paragraph("From the vertices of each surface to the other, both ways together, by area, mm.");
        page.table("", DISTANCES, distances());
        if (!pictures.isEmpty()) {
            page.figure(
                    "Distance from the target: the body at end-expiration, and as fitted, in one scale.",
                    pictures.toArray(Picture[]::new));
        }
        page.section("Parameters");
        page.paragraph(
                "A step is a twentieth of the way between the bounds (by the logarithm where they are far apart); distances are"
                        + " the mean that was made small, mm, with that parameter alone moved.");
        page.table("", PARAMETERS, parameters());
        page.section("The fitted breath");
        page.points(result.observed().entrySet().stream()
                .filter(e -> e.getKey().endsWith("_mm") || e.getKey().endsWith("_ml"))
                .map(e -> e.getKey() + " " + number(e.getValue()))
                .toArray(String[]::new));
        page.section("To do it again");
        page.code("phrenic run scenario.yaml --out result");
        return page;
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        FitSetup setup = result.setup();
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("anatomy", setup.base().anatomy());
        map.put("alignment", setup.alignment());
        map.put("initial_mean_mm", result.initialMm());
        map.put("untuned_mean_mm", result.untunedMm());
        map.put("residual_mean_mm", result.bestMm());
        map.put("ratio", result.ratio());
        map.put("evaluations", result.trials().length);
        map.put("population", setup.populationSize());
        map.put("seed", setup.seed());
        map.put("ended", result.ended());
        map.put("reproduced", result.reproduced());
        map.put("wall_s", result.wallS());
        if (!Double.isNaN(result.cpuPerEvaluationS())) {
            map.put("cpu_per_evaluation_s", result.cpuPerEvaluationS());
        }
        map.put("targets", result.targets().stream().map(FitReport::values).toList());
        List<Object> parameters = new ArrayList<>();
        for (int i = 0; i < result.values().length; i++) {
            FitParameter p = setup.parameters().get(i);
            Map<String, Object> row = new LinkedHashMap<>();
            row.put("key", p.parameter().key());
            row.put("unit", p.parameter().unit());
            row.put("minimum", p.minimum());
            row.put("maximum", p.maximum());
            row.put("start", p.start());
            row.put("fitted", result.values()[i]);
            if (!result.sensitivity().isEmpty()) {
                FitResult.Effect e = result.sensitivity().get(i);
                row.put("step", e.step());
                row.put("with_a_step_less_mm", Double.isNaN(e.belowMm()) ? null : e.belowMm());
                row.put("with_a_step_more_mm", Double.isNaN(e.aboveMm()) ? null : e.aboveMm());
            }
            parameters.add(row);
        }
        map.put("parameters", parameters);
        map.put("observed", result.observed());
        return map;
    }

    private static Map<String, Object> values(FitResult.TargetResult t) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("target", t.target().name());
        map.put("weight", t.target().weight());
        map.put("initial", values(t.initial()));
        map.put("residual", values(t.residual()));
        map.put("ratio", t.ratio());
        if (t.residualHeldOut() != null) {
            map.put("initial_held_out_half", values(t.initialHeldOut()));
            map.put("residual_held_out_half", values(t.residualHeldOut()));
            map.put("residual_fitted_half", values(t.residualFitted()));
        }
        return map;
    }

    private static Map<String, Object> values(FitDistances distances) {
        DistanceSummary d = distances.summary();
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("mean_mm", d.mean());
        map.put("sd_mm", d.deviation());
        map.put("rms_mm", d.rms());
        map.put("median_mm", d.median());
        map.put("percentile_95_mm", d.percentile95());
        map.put("maximum_mm", d.maximum());
        return map;
    }

    /** Writes fit.json, fit.csv and scenario.yaml into a folder. */
    public void write(Path folder) {
        JsonWriter.write(folder.resolve("fit.json"), values());
        CsvWriter.write(
                folder.resolve("fit.csv"),
                PARAMETERS.stream().map(Column::heading).toList(),
                parameters());
        YamlWriter.write(folder.resolve("scenario.yaml"), result.scenario().toMap());
    }

    private static String mm(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }

    /** Four significant digits. */
    static String number(double value) {
        return value == 0
                ? "0"
                : new java.math.BigDecimal(value)
                        .round(new java.math.MathContext(4))
                        .stripTrailingZeros()
                        .toPlainString();
    }
}
