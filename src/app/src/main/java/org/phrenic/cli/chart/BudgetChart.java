package org.phrenic.cli.chart;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.study.error.BudgetPoint;

/**
 * A chart of speed against the whole error, with logarithmic axes. The upper panel has every integrator on the scenes
 * that were measured with all of them, the lower one the defaults of all scenes; colours tell the meshes.
 */
public final class BudgetChart {
    private static final int PANEL_HEIGHT = 480;
    private static final int MARGIN_HEIGHT = 150;
    private static final Shape POINT = new Ellipse2D.Double(-4.5, -4.5, 9, 9);
    private static final Shape RING = new Ellipse2D.Double(-9, -9, 18, 18);

    private BudgetChart() {}

    /** Draws the points. */
    public static void write(List<BudgetPoint> points, Path picture) {
        System.setProperty("java.awt.headless", "true");
        List<BudgetPoint> defaults =
                points.stream().filter(p -> p.row().usual()).toList();
        List<BudgetPoint> compared = points.stream()
                .filter(p -> points.stream().anyMatch(q -> !q.row().usual() && isSameScene(p, q)))
                .toList();
        double slowest =
                points.stream().mapToDouble(p -> p.row().realTime()).min().orElse(1);
        double fastest =
                points.stream().mapToDouble(p -> p.row().realTime()).max().orElse(1);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(new DecadeAxis(
                "speed, x real time: simulated time over processor time, one thread", slowest / 1.5, 2.5 * fastest));
        all.setGap(22);
        List<String> meshes =
                points.stream().map(p -> p.row().mesh()).distinct().toList();
        if (!compared.isEmpty()) {
            all.add(panel(compared, meshes, "every integrator: whole error, % of excursion", BudgetPoint::integrator));
        }
        all.add(panel(defaults, meshes, "defaults: whole error, % of excursion", BudgetChart::scene));
        JFreeChart chart = ChartStyle.chart("Speed against the whole error", all);
        chart.addSubtitle(0, legend(meshes));
        ChartStyle.write(picture, chart, MARGIN_HEIGHT + PANEL_HEIGHT * (compared.isEmpty() ? 1 : 2));
    }

    private static boolean isSameScene(BudgetPoint p, BudgetPoint q) {
        return p.row().body().equals(q.row().body())
                && p.row().breath().equals(q.row().breath())
                && p.row().mesh().equals(q.row().mesh());
    }

    private static String scene(BudgetPoint p) {
        return p.row().body() + ", " + p.row().breath();
    }

    @FunctionalInterface
    private interface Label {
        String of(BudgetPoint point);
    }

    private static XYPlot panel(List<BudgetPoint> points, List<String> meshes, String title, Label label) {
        double low =
                points.stream().mapToDouble(BudgetPoint::wholePercent).min().orElse(1);
        double high =
                points.stream().mapToDouble(BudgetPoint::wholePercent).max().orElse(1);
        XYPlot plot = ChartStyle.panel(new XYPlot());
        plot.setRangeAxis(new DecadeAxis(title, low / 1.5, high * 1.5));
        XYSeriesCollection data = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
        for (int i = 0; i < meshes.size(); i++) {
            XYSeries series = new XYSeries(meshes.get(i));
            for (BudgetPoint p : points) {
                if (p.row().mesh().equals(meshes.get(i))) {
                    series.add(p.row().realTime(), p.wholePercent());
                }
            }
            data.addSeries(series);
            renderer.setSeriesPaint(i, ChartStyle.colour(i));
            renderer.setSeriesShape(i, POINT);
        }
        XYSeries rings = new XYSeries("default");
        points.stream()
                .filter(p -> p.row().usual())
                .forEach(p -> rings.add(p.row().realTime(), p.wholePercent()));
        data.addSeries(rings);
        ChartStyle.rings(meshes.size(), RING, renderer);
        plot.setDataset(data);
        plot.setRenderer(renderer);
        plot.addAnnotation(new PointLabels(points.stream()
                .sorted(Comparator.comparingDouble(BudgetPoint::wholePercent))
                .map(p -> new PointLabels.Label(p.row().realTime(), p.wholePercent(), label.of(p)))
                .toList()));
        return plot;
    }

    private static LegendTitle legend(List<String> meshes) {
        LegendItemCollection items = new LegendItemCollection();
        for (int i = 0; i < meshes.size(); i++) {
            items.add(new LegendItem(meshes.get(i), null, null, null, POINT, ChartStyle.colour(i)));
        }
        return ChartStyle.legend(items, RING);
    }
}
