package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.query.DistanceHistogram;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;

/** The results of {@code phrenic compare}. */
public final class CompareReport {
    private static final int BINS = 20;
    /** Distance statistics by key, in the order of the table. */
    private static final Map<String, ToDoubleFunction<DistanceSummary>> FIGURES = new LinkedHashMap<>();

    static {
        FIGURES.put("mean_mm", DistanceSummary::mean);
        FIGURES.put("sd_mm", DistanceSummary::deviation);
        FIGURES.put("rms_mm", DistanceSummary::rms);
        FIGURES.put("median_mm", DistanceSummary::median);
        FIGURES.put("percentile_95_mm", DistanceSummary::percentile95);
        FIGURES.put("maximum_mm", DistanceSummary::maximum);
    }

    private final Path a;
    private final Path b;
    private final SurfaceComparison comparison;

    public CompareReport(Path a, Path b, SurfaceComparison comparison) {
        this.a = a;
        this.b = b;
        this.comparison = comparison;
    }

    public Map<String, Object> values(List<String> pictures) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("a", a.toString());
        values.put("b", b.toString());
        values.put("a_to_b", oneWay(comparison.aToB()));
        values.put("b_to_a", oneWay(comparison.bToA()));
        Map<String, Object> both = new LinkedHashMap<>();
        both.put("per_vertex", figures(comparison.perVertex()));
        both.put("by_area", figures(comparison.byArea()));
        values.put("symmetric", both);
        values.put("hausdorff_mm", comparison.hausdorff());
        comparison.corresponding().ifPresent(d -> values.put("corresponding_vertices", figures(d)));
        if (!pictures.isEmpty()) {
            values.put("pictures", pictures);
        }
        values.put("notice", Disclaimer.TEXT);
        return values;
    }

    private static Map<String, Object> oneWay(SurfaceComparison.DirectedDistances way) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("signed", way.signed());
        if (way.signed()) {
            values.put("signed_mean_mm", way.signedMean());
        }
        values.put("per_vertex", figures(way.perVertex()));
        values.put("by_area", figures(way.byArea()));
        DistanceHistogram histogram = way.histogram(BINS);
        values.put("histogram_edges_mm", histogram.edgesMm());
        values.put("histogram_area_shares", histogram.shares());
        return values;
    }

    private static Map<String, Object> figures(DistanceSummary d) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("vertices", d.points());
        FIGURES.forEach((key, figure) -> values.put(key, figure.applyAsDouble(d)));
        return values;
    }

    public String table() {
        TextTable table = new TextTable(false, false, true, true, true, true, true, true, true, true);
        table.row("mm", "weight", "vertices", "mean", "sd", "rms", "median", "95 %", "maximum", "signed mean");
        row(table, "A to B", "vertex", comparison.aToB().perVertex(), Double.NaN);
        row(table, "", "area", comparison.aToB().byArea(), comparison.aToB().signedMean());
        row(table, "B to A", "vertex", comparison.bToA().perVertex(), Double.NaN);
        row(table, "", "area", comparison.bToA().byArea(), comparison.bToA().signedMean());
        row(table, "both", "vertex", comparison.perVertex(), Double.NaN);
        row(table, "", "area", comparison.byArea(), Double.NaN);
        comparison.corresponding().ifPresent(d -> row(table, "same number", "vertex", d, Double.NaN));
        return "A  " + a + "\nB  " + b + "\n\n" + table.text()
                + String.format(Locale.ROOT, "%nHausdorff distance %.3f mm, at vertices%n", comparison.hausdorff());
    }

    private static void row(TextTable table, String way, String weight, DistanceSummary d, double signedMean) {
        List<String> cells = new ArrayList<>(List.of(way, weight, Integer.toString(d.points())));
        FIGURES.values().forEach(figure -> cells.add(String.format(Locale.ROOT, "%.3f", figure.applyAsDouble(d))));
        cells.add(Double.isNaN(signedMean) ? "" : String.format(Locale.ROOT, "%+.3f", signedMean));
        table.row(cells.toArray(String[]::new));
    }
}
