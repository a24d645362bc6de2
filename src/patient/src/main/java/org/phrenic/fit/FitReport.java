package org.phrenic.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.Numbers;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.SearchSpace;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.scenario.RunSettings;

/** The result of a fit as tables, as a document and as JSON values. */
public record FitReport(FitResult result) {
    /** Columns of {@link #distances}. */
    public static final List<Column> DISTANCES =
            Column.list("target | body | # mean | # SD | # RMS | # 95 % | # residual / initial");
    /** Columns of {@link #parameters}. */
    public static final List<Column> PARAMETERS =
            Column.list("parameter | unit | # bounds | # start | # fitted | # step"
                    + " | # distance with a step less | # with a step more");

    /** Significant digits of a value of a parameter. */
    private static final int DIGITS = 4;

    /** Distances before and after the fit, mm, one row per target. */
    public List<List<String>> distances() {
        List<List<String>> rows = new ArrayList<>();
        for (FitResult.TargetResult t : result.targets()) {
            String name = t.target().name() + (t.target().weight() > 0 ? "" : " (held out)");
            rows.add(row(name, "at end-expiration", t.initial(), ""));
            rows.add(row("", "fitted", t.residual(), ratio(t.ratio())));
            if (t.residualFitted() != null) {
                double ratio = t.residualHeldOut().mean() / t.initialHeldOut().mean();
                rows.add(row("", "fitted, half fitted to", t.residualFitted(), ""));
                rows.add(row("", "at end-expiration, half held out", t.initialHeldOut(), ""));
                rows.add(row("", "fitted, half held out", t.residualHeldOut(), ratio(ratio)));
            }
        }
        return rows;
    }

    private static List<String> row(String target, String body, FitDistances distances, String ratio) {
        DistanceSummary d = distances.summary();
        return List.of(target, body, mm(d.mean()), mm(d.deviation()), mm(d.rms()), mm(d.percentile95()), ratio);
    }

    static String ratio(double value) {
        return Double.isFinite(value) ? Numbers.format("%.3f", value) : "";
    }

    /** A number for JSON; null where there is none, such as a ratio to a distance of 0. */
    public static Double finite(double value) {
        return Double.isFinite(value) ? value : null;
    }

    /** Parameters and their effects, one row per parameter. */
    public List<List<String>> parameters() {
        return IntStream.range(0, result.values().length)
                .mapToObj(this::parameterRow)
                .toList();
    }

    private List<String> parameterRow(int i) {
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
            row.add(effect(e.belowMm()));
            row.add(effect(e.aboveMm()));
        }
        return row;
    }

    private static String effect(double mm) {
        return Double.isNaN(mm) ? "bound" : Double.isInfinite(mm) ? "failed" : mm(mm);
    }

    /** The result in a few sentences. */
    public String summary() {
        FitSetup setup = result.setup();
        return Numbers.format(
                "The mean distance to the fitted targets went from %.2f mm (body at end-expiration; %s) to %.2f mm%s."
                        + " %d parameters, %d evaluations in generations of %d, seed %d; it ended because %s. %s",
                result.initialMm(),
                Double.isNaN(result.untunedMm())
                        ? "the breath with the initial parameters failed"
                        : mm(result.untunedMm()) + " mm breathed in with the initial parameters",
                result.bestMm(),
                Double.isFinite(result.ratio()) ? ", a ratio of " + ratio(result.ratio()) : "",
                setup.parameters().size(),
                result.search().trials().length,
                setup.populationSize(),
                setup.options().search().seed(),
                result.search().ended(),
                result.reproduced()
                        ? "scenario.yaml was run and gives the same state bit by bit."
                        : "scenario.yaml was run and does NOT give the same state.");
    }

    /** What limits the fit: warnings, parameters at a bound and failed breaths, one sentence each. */
    public List<String> limits() {
        List<String> limits = new ArrayList<>(result.search().warnings());
        List<String> keys = boundKeys();
        if (!keys.isEmpty()) {
            limits.add("At a bound: " + String.join(", ", keys) + ".");
        }
        limits.addAll(FitTarget.withoutBase(result.setup().targets()));
        result.search().failures().forEach(f -> limits.add(f.sentence()));
        return limits;
    }

    private List<String> boundKeys() {
        List<FitParameter> parameters = result.setup().parameters();
        SearchSpace space = new SearchSpace(parameters);
        return IntStream.range(0, parameters.size())
                .filter(i -> space.isAtBound(result.values(), i))
                .mapToObj(i -> parameters.get(i).parameter().key())
                .toList();
    }

    /** The report as a document. */
    public ReportDocument document(List<Picture> pictures) {
        FitSetup setup = result.setup();
        ReportDocument page = new ReportDocument(
                "Fit to a second breath level",
                "The body " + RunSettings.bodyLabel(setup.base().anatomy())
                        + " breathed in and held, with the parameters that bring its surfaces nearest to"
                        + " those given.");
        page.paragraph(summary());
        page.paragraph("Rigid alignment: " + setup.options().alignment() + ".");
        page.section("Distances");
        page.paragraph("From the vertices of each surface to the other, both ways together, by area, mm.");
        page.table("", DISTANCES, distances());
        if (!pictures.isEmpty()) {
            page.figure(
                    "Distance from the target: the body at end-expiration, and as fitted, in one scale.",
                    pictures.toArray(Picture[]::new));
        }
        result.landmarks().ifPresent(errors -> {
            LandmarkTable table = new LandmarkTable(errors);
            page.section("Inside the lungs");
            page.paragraph(table.shifts());
            page.table("", LandmarkTable.COLUMNS, table.rows());
        });
        page.section("Parameters");
        page.paragraph(
                "A step is a twentieth of the way between the bounds (by the logarithm where they are far apart);"
                        + " distances are the objective of the fit, mm, with the value of that parameter alone moved.");
        page.table("", PARAMETERS, parameters());
        if (!limits().isEmpty()) {
            page.section("What limits it");
            page.points(limits().toArray(String[]::new));
        }
        page.section("The fitted breath");
        page.points(result.observed().entrySet().stream()
                .filter(e -> e.getKey().endsWith("_mm") || e.getKey().endsWith("_ml"))
                .map(e -> e.getKey() + " " + number(e.getValue()))
                .toArray(String[]::new));
        page.section("Reproduction");
        page.code("phrenic run scenario.yaml --out result");
        return page;
    }

    /** The report as JSON values. */
    public Map<String, Object> values() {
        FitSetup setup = result.setup();
        OrderedValues map = new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with("program", FitSetup.PROGRAM)
                .with("anatomy", setup.base().anatomy())
                .with("alignment", setup.options().alignment())
                .with("initial_mean_mm", result.initialMm())
                .with("untuned_mean_mm", finite(result.untunedMm()))
                .with("residual_mean_mm", result.bestMm())
                .with("ratio", finite(result.ratio()))
                .with("evaluations", result.search().trials().length)
                .with("population", setup.populationSize())
                .with("seed", setup.options().search().seed())
                .with("ended", result.search().ended())
                .with("warnings", result.search().warnings())
                .with("at_bounds", boundKeys())
                .with(
                        "failed_breaths",
                        result.search().failures().stream()
                                .map(f -> new OrderedValues()
                                        .with("reason", f.reason())
                                        .with("count", f.count())
                                        .with("succeeded_with_less_drive", f.gentler()))
                                .toList())
                .with("reproduced", result.reproduced())
                .with("wall_s", result.search().wallS());
        if (!Double.isNaN(result.search().cpuPerEvaluationS())) {
            map.put("cpu_per_evaluation_s", result.search().cpuPerEvaluationS());
        }
        return map.with(
                        "targets",
                        result.targets().stream().map(FitReport::values).toList())
                .with(
                        "parameters",
                        IntStream.range(0, result.values().length)
                                .mapToObj(this::parameterValues)
                                .toList())
                .with(
                        "landmarks",
                        result.landmarks()
                                .map(e -> new LandmarkTable(e).values())
                                .orElse(null))
                .with("observed", result.observed());
    }

    private OrderedValues parameterValues(int i) {
        FitParameter p = result.setup().parameters().get(i);
        OrderedValues row = new OrderedValues()
                .with("key", p.parameter().key())
                .with("unit", p.parameter().unit())
                .with("minimum", p.minimum())
                .with("maximum", p.maximum())
                .with("start", p.start())
                .with("fitted", result.values()[i]);
        if (!result.sensitivity().isEmpty()) {
            FitResult.Effect e = result.sensitivity().get(i);
            row.with("step", e.step())
                    .with("with_a_step_less_mm", finite(e.belowMm()))
                    .with("with_a_step_more_mm", finite(e.aboveMm()));
        }
        return row;
    }

    private static OrderedValues values(FitResult.TargetResult t) {
        OrderedValues map = new OrderedValues()
                .with("target", t.target().name())
                .with("weight", t.target().weight())
                .with("initial", values(t.initial()))
                .with("residual", values(t.residual()))
                .with("ratio", finite(t.ratio()));
        if (t.residualHeldOut() != null) {
            map.with("initial_held_out_half", values(t.initialHeldOut()))
                    .with("residual_held_out_half", values(t.residualHeldOut()))
                    .with("residual_fitted_half", values(t.residualFitted()));
        }
        return map;
    }

    private static Map<String, Double> values(FitDistances distances) {
        return distances.summary().values();
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

    static String mm(double value) {
        return Numbers.format("%.2f", value);
    }

    /** Formats a number with four significant digits. */
    private static String number(double value) {
        return Numbers.trimmed(value, DIGITS);
    }
}
