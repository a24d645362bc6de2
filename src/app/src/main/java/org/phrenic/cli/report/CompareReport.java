package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.mesh.query.DistanceHistogram;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;

/** What {@code phrenic compare} says. */
public final class CompareReport {
    private static final int BINS = 20;

    private final Path a;
    private final Path b;
    private final SurfaceComparison comparison;

    public CompareReport(Path a, Path b, SurfaceComparison comparison) {
        this.a = a;
        this.b = b;
        this.comparison = comparison;
    }

    /** Keys and values of the JSON. */
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
        values.put("notice", CliNotice.TEXT);
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
        values.put("mean_mm", d.mean());
        values.put("sd_mm", d.deviation());
        values.put("rms_mm", d.rms());
        values.put("median_mm", d.median());
        values.put("percentile_95_mm", d.percentile95());
        values.put("maximum_mm", d.maximum());
        return values;
    }

    /** The table. */
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
        table.row(
                way,
                weight,
                Integer.toString(d.points()),
                shown(d.mean()),
                shown(d.deviation()),
                shown(d.rms()),
                shown(d.median()),
                shown(d.percentile95()),
                shown(d.maximum()),
                Double.isNaN(signedMean) ? "" : String.format(Locale.ROOT, "%+.3f", signedMean));
    }

    private static String shown(double mm) {
        return String.format(Locale.ROOT, "%.3f", mm);
    }
}
