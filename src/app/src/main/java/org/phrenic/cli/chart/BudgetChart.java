package org.phrenic.cli.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.study.error.BudgetPoint;

/**
 * A chart of speed against the whole error, with logarithmic axes. The upper panel has every integrator on the scenes
 * that were measured with all of them, the lower one the defaults of all scenes.
 */
public final class BudgetChart {
    private static final int PANEL_HEIGHT = 480;
    private static final int MARGIN_HEIGHT = 150;
    /** Ratio of speeds up to which a point is beside a slower one. */
    private static final double BESIDE = 1.5;
    /** Ratio of speeds below which two points are one above the other. */
    private static final double EQUAL = 1.1;
    /** Ratio of errors up to which two labels may meet. */
    private static final double LEVEL = 1.25;

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
        if (!compared.isEmpty()) {
            all.add(panel(compared, "every integrator: whole error, % of excursion", BudgetChart::compared));
        }
        all.add(panel(defaults, "defaults: whole error, % of excursion", BudgetChart::scene));
        JFreeChart chart = ChartStyle.chart("Speed against the whole error", all);
        ChartStyle.write(picture, chart, MARGIN_HEIGHT + PANEL_HEIGHT * (compared.isEmpty() ? 1 : 2));
    }

    private static boolean isSameScene(BudgetPoint p, BudgetPoint q) {
        return p.row().body().equals(q.row().body())
                && p.row().breath().equals(q.row().breath())
                && p.row().mesh().equals(q.row().mesh());
    }

    private static String compared(BudgetPoint p) {
        return p.integrator() + ", " + p.row().mesh();
    }

    private static String scene(BudgetPoint p) {
        return String.join(", ", p.row().body(), p.row().breath(), p.row().mesh());
    }

    @FunctionalInterface
    private interface Label {
        String of(BudgetPoint point);
    }

    private static XYPlot panel(List<BudgetPoint> points, String title, Label label) {
        double low =
                points.stream().mapToDouble(BudgetPoint::wholePercent).min().orElse(1);
        double high =
                points.stream().mapToDouble(BudgetPoint::wholePercent).max().orElse(1);
        XYPlot plot = ChartStyle.panel(new XYPlot());
        plot.setRangeAxis(new DecadeAxis(title, low / 1.5, high * 1.5));
        XYSeriesCollection data = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
        List<String> meshes =
                points.stream().map(p -> p.row().mesh()).distinct().toList();
        for (int i = 0; i < meshes.size(); i++) {
            XYSeries series = new XYSeries(meshes.get(i));
            for (BudgetPoint p : points) {
                if (p.row().mesh().equals(meshes.get(i))) {
                    series.add(p.row().realTime(), p.wholePercent());
                }
            }
            data.addSeries(series);
            renderer.setSeriesPaint(i, ChartStyle.colour(i));
            renderer.setSeriesShape(i, new Ellipse2D.Double(-4.5, -4.5, 9, 9));
        }
        XYSeries rings = new XYSeries("default");
        points.stream()
                .filter(p -> p.row().usual())
                .forEach(p -> rings.add(p.row().realTime(), p.wholePercent()));
        data.addSeries(rings);
        int last = meshes.size();
        ChartStyle.line(last, Color.BLACK, 2f, renderer);
        renderer.setSeriesShape(last, new Ellipse2D.Double(-9, -9, 18, 18));
        renderer.setSeriesShapesFilled(last, Boolean.FALSE);
        renderer.setSeriesOutlineStroke(last, new BasicStroke(2f));
        plot.setDataset(data);
        plot.setRenderer(renderer);
        List<BudgetPoint> bySpeed = points.stream()
                .sorted(Comparator.comparingDouble(p -> p.row().realTime()))
                .toList();
        for (int i = 0; i < bySpeed.size(); i++) {
            // Neighbours have their labels above and below, and a slower one to its left, so that they do not overlap.
            BudgetPoint p = bySpeed.get(i);
            boolean left = bySpeed.subList(i + 1, bySpeed.size()).stream().anyMatch(q -> isBeside(p, q));
            annotate(plot, p, label, i % 2 == 0, left);
        }
        return plot;
    }

    /** Whether a faster point lies where the label of a point would be to its right. */
    private static boolean isBeside(BudgetPoint p, BudgetPoint faster) {
        double ratio = faster.row().realTime() / p.row().realTime();
        double height = Math.abs(Math.log(faster.wholePercent() / p.wholePercent()));
        return ratio > EQUAL && ratio < BESIDE && height < Math.log(LEVEL);
    }

    private static void annotate(XYPlot plot, BudgetPoint p, Label label, boolean above, boolean left) {
        String name = label.of(p) + (p.row().usual() ? " (default)" : "");
        String text = left ? name + "    " : "    " + name;
        XYTextAnnotation note = new XYTextAnnotation(text, p.row().realTime(), p.wholePercent());
        note.setFont(ChartStyle.font(12));
        if (left) {
            note.setTextAnchor(above ? TextAnchor.BOTTOM_RIGHT : TextAnchor.TOP_RIGHT);
        } else {
            note.setTextAnchor(above ? TextAnchor.BOTTOM_LEFT : TextAnchor.TOP_LEFT);
        }
        plot.addAnnotation(note);
    }
}
