package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.query.DistanceHistogram;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;

/** The results of {@code phrenic compare}. */
public record CompareReport(Path a, Path b, SurfaceComparison comparison) {
    private static final int BINS = 20;

    public Map<String, Object> values(List<String> pictures) {
        OrderedValues values = new OrderedValues()
                .with("a", a.toString())
                .with("b", b.toString())
                .with("a_to_b", oneWay(comparison.aToB()))
                .with("b_to_a", oneWay(comparison.bToA()))
                .with("symmetric", figures(new OrderedValues(), comparison.perVertex(), comparison.byArea()))
                .with("hausdorff_mm", comparison.hausdorff());
        comparison.corresponding().ifPresent(d -> values.put("corresponding_vertices", figures(d)));
        if (!pictures.isEmpty()) {
            values.put("pictures", pictures);
        }
        return values.with("notice", Disclaimer.TEXT);
    }

    private static OrderedValues oneWay(SurfaceComparison.DirectedDistances way) {
        OrderedValues values = new OrderedValues().with("signed", way.signed());
        if (way.signed()) {
            values.put("signed_mean_mm", way.signedMean());
        }
        DistanceHistogram histogram = way.histogram(BINS);
        return figures(values, way.perVertex(), way.byArea())
                .with("histogram_edges_mm", histogram.edgesMm())
                .with("histogram_area_shares", histogram.shares());
    }

    private static OrderedValues figures(OrderedValues values, DistanceSummary perVertex, DistanceSummary byArea) {
        return values.with("per_vertex", figures(perVertex)).with("by_area", figures(byArea));
    }

    private static OrderedValues figures(DistanceSummary d) {
        OrderedValues values = new OrderedValues().with("vertices", d.points());
        values.putAll(d.values());
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
                + Numbers.format("\nHausdorff distance %.3f mm, at vertices\n", comparison.hausdorff());
    }

    private static void row(TextTable table, String way, String weight, DistanceSummary d, double signedMean) {
        List<String> cells = new ArrayList<>(List.of(way, weight, Integer.toString(d.points())));
        d.values().values().forEach(value -> cells.add(Numbers.format("%.3f", value)));
        cells.add(Double.isNaN(signedMean) ? "" : Numbers.format("%+.3f", signedMean));
        table.row(cells.toArray(String[]::new));
    }
}
