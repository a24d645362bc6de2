package org.phrenic.cli.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Paint;
import java.awt.Polygon;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.study.error.ErrorTable;

/**
 * A chart of CPU time against error, with one panel per material and logarithmic axes. A line joins the Pareto-optimal
 * settings.
 */
public final class ErrorChart {
    private static final int PANEL_HEIGHT = 560;
    private static final int MARGIN_HEIGHT = 150;
    /** The time axis begins at the minimum time divided by this factor, which leaves room for labels. */
    private static final double LABEL_ROOM = 4;
    /** Minimum ratio of the errors of labelled points; closer labels would overlap. */
    private static final double MIN_LABEL_RATIO = 1.12;
    /** Target error of a usable setting, percent of the excursion. */
    private static final double PHYSICAL_TARGET_PERCENT = 0.1;

    private static final double PAPER_TARGET_PERCENT = 0.01;
    private static final Color FRONT = new Color(0x30363c);
    private static final Color TARGET = new Color(0x9a1b1b);

    private ErrorChart() {}

    /** Draws a table of settings; for each material, only the scene with the most nodes. */
    public static void write(ErrorTable table, String title, Path picture) {
        System.setProperty("java.awt.headless", "true");
        List<ErrorTable.Row> rows = table.rows();
        Map<String, List<ErrorTable.Row>> materials = rows.stream()
                .collect(Collectors.groupingBy(ErrorTable.Row::material, LinkedHashMap::new, Collectors.toList()));
        List<String> integrators =
                rows.stream().map(ErrorChart::integrator).distinct().toList();
        double least = rows.stream().mapToDouble(r -> r.point().cpuS()).min().orElse(1);
        double most = rows.stream().mapToDouble(r -> r.point().cpuS()).max().orElse(1);
        CombinedDomainXYPlot all =
                new CombinedDomainXYPlot(new DecadeAxis("processor time, s", least / LABEL_ROOM, 1.3 * most));
        all.setGap(22);
        materials.forEach((material, same) -> {
            int nodes = same.stream().mapToInt(ErrorTable.Row::nodes).max().orElse(0);
            all.add(panel(same.stream().filter(r -> r.nodes() == nodes).toList(), integrators));
        });
        JFreeChart chart = ChartStyle.chart(title, all);
        chart.addSubtitle(0, legend(integrators));
        ChartStyle.write(picture, chart, MARGIN_HEIGHT + PANEL_HEIGHT * materials.size());
    }

    private static String integrator(ErrorTable.Row row) {
        return row.point().settings().integrator().label();
    }

    private static XYPlot panel(List<ErrorTable.Row> rows, List<String> integrators) {
        ErrorTable.Row any = rows.get(0);
        double target = any.material().equals("paper") ? PAPER_TARGET_PERCENT : PHYSICAL_TARGET_PERCENT;
        double low = rows.stream().mapToDouble(ErrorTable.Row::rmsPercent).reduce(target, Math::min);
        double high = rows.stream().mapToDouble(ErrorTable.Row::rmsPercent).reduce(target, Math::max);
        String label = any.material() + ", " + any.preset() + ", " + any.resolution()
                + " resolution: rms error of the diaphragm, % of excursion";
        XYPlot plot = ChartStyle.panel(new XYPlot());
        plot.setRangeAxis(new DecadeAxis(label, low / 2, high * 2));
        drawParetoFront(plot, rows);
        drawSettings(plot, rows, integrators);
        drawTargetLine(plot, target);
        return plot;
    }

    private static void drawParetoFront(XYPlot plot, List<ErrorTable.Row> rows) {
        List<ErrorTable.Row> front = rows.stream()
                .filter(r -> r.point().paretoOptimal())
                .sorted(Comparator.comparingDouble(r -> r.point().cpuS()))
                .toList();
        double labelled = Double.POSITIVE_INFINITY;
        for (ErrorTable.Row r : front) {
            if (r.rmsPercent() * MIN_LABEL_RATIO < labelled) {
                String label = r.point().settings().label() + "   ";
                XYTextAnnotation text = new XYTextAnnotation(label, r.point().cpuS(), r.rmsPercent());
                text.setFont(ChartStyle.font(12));
                text.setTextAnchor(TextAnchor.TOP_RIGHT);
                text.setPaint(FRONT);
                plot.addAnnotation(text);
                labelled = r.rmsPercent();
            }
        }
        plot.setDataset(1, new XYSeriesCollection(series("front", front, r -> true)));
        plot.setRenderer(1, ChartStyle.line(0, FRONT, 1.6f, new XYLineAndShapeRenderer(true, false)));
    }

    private static XYSeries series(String name, List<ErrorTable.Row> rows, Predicate<ErrorTable.Row> condition) {
        XYSeries series = new XYSeries(name);
        rows.stream().filter(condition).forEach(r -> series.add(r.point().cpuS(), r.rmsPercent()));
        return series;
    }

    private static void drawSettings(XYPlot plot, List<ErrorTable.Row> rows, List<String> integrators) {
        XYSeriesCollection all = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
        for (int i = 0; i < integrators.size(); i++) {
            String integrator = integrators.get(i);
            all.addSeries(series(integrator, rows, r -> integrator(r).equals(integrator)));
            renderer.setSeriesPaint(i, ChartStyle.colour(i));
            renderer.setSeriesShape(i, shape(i));
        }
        all.addSeries(series("default", rows, r -> r.point().isDefault()));
        ChartStyle.rings(integrators.size(), new Ellipse2D.Double(-11, -11, 22, 22), renderer);
        renderer.setUseOutlinePaint(false);
        plot.setDataset(0, all);
        plot.setRenderer(0, renderer);
    }

    private static void drawTargetLine(XYPlot plot, double percent) {
        float[] dashes = {7, 5};
        ValueMarker marker = new ValueMarker(
                percent, TARGET, new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, dashes, 0));
        marker.setLabel("aim: " + percent + " %");
        marker.setLabelFont(ChartStyle.font(13));
        marker.setLabelPaint(TARGET);
        marker.setLabelBackgroundColor(new Color(0, 0, 0, 0));
        marker.setLabelAnchor(RectangleAnchor.TOP_RIGHT);
        marker.setLabelTextAnchor(TextAnchor.BOTTOM_RIGHT);
        plot.addRangeMarker(marker);
    }

    private static LegendTitle legend(List<String> integrators) {
        LegendItemCollection items = new LegendItemCollection();
        for (int i = 0; i < integrators.size(); i++) {
            Paint colour = ChartStyle.colour(i);
            items.add(new LegendItem(integrators.get(i), null, null, null, shape(i), colour));
        }
        return ChartStyle.legend(items, new Ellipse2D.Double(-7, -7, 14, 14));
    }

    private static Shape shape(int series) {
        return switch (series % 3) {
            case 0 -> new Ellipse2D.Double(-4.5, -4.5, 9, 9);
            case 1 -> new Rectangle2D.Double(-4, -4, 8, 8);
            default -> new Polygon(new int[] {0, 5, -5}, new int[] {-5, 4, 4}, 3);
        };
    }
}
