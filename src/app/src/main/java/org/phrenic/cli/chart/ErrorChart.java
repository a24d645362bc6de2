package org.phrenic.cli.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.document.CsvTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.scene.export.PngFile;

/**
 * Speed against error as a picture: a panel a material, time of a breath and error on axes of powers of ten, the
 * settings that nothing beats joined by a line.
 */
public final class ErrorChart {
    private static final int WIDTH = 1200;
    private static final int PANEL_HEIGHT = 560;
    private static final int MARGIN_HEIGHT = 150;
    private static final double LABEL_ROOM = 4;
    /** Names of points whose errors differ by less than this would lie over each other. */
    private static final double MIN_LABEL_RATIO = 1.12;

    /** Largest error that is aimed for in a setting fit for use, per cent of the excursion. */
    private static final double PHYSICAL_TARGET_PERCENT = 0.1;

    private static final double PAPER_TARGET_PERCENT = 0.01;

    /** Colours that any colour vision tells apart (Okabe and Ito 2008), in the order in which integrators come. */
    private static final int[] COLOURS = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x8a6d00, 0x56b4e9};

    private ErrorChart() {}

    /** A row of the table, as far as it is drawn. */
    private record Point(
            String integrator, String label, double cpuS, double percent, boolean onFront, boolean isDefault) {}

    /**
     * Draws a table of settings, of each material the scene with the most nodes.
     *
     * @param table as {@code phrenic bench error} writes it
     * @param title above the panels
     * @throws org.phrenic.format.BadInputException if a column is missing
     */
    public static void write(Path table, String title, Path picture) {
        System.setProperty("java.awt.headless", "true");
        CsvTable csv = CsvTable.read(table);
        Set<String> materials = new LinkedHashSet<>(csv.texts("material"));
        List<String> integrators = List.copyOf(new LinkedHashSet<>(csv.texts("integrator")));
        double[] cpu = csv.numbers("cpu_s");
        // What lies left of the front is free of settings: there its points are named.
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(new DecadeAxis(
                "processor time of a breath, s",
                Arrays.stream(cpu).min().orElse(1) / LABEL_ROOM,
                1.3 * Arrays.stream(cpu).max().orElse(1)));
        all.setGap(22);
        for (String material : materials) {
            all.add(panel(csv, material, integrators));
        }
        JFreeChart chart = new JFreeChart(title, font(Font.PLAIN, 20), all, false);
        chart.setBackgroundPaint(Color.WHITE);
        chart.addSubtitle(legend(integrators));
        TextTitle notice = new TextTitle(Disclaimer.TEXT, font(Font.PLAIN, 13));
        notice.setPosition(RectangleEdge.BOTTOM);
        notice.setHorizontalAlignment(HorizontalAlignment.LEFT);
        chart.addSubtitle(notice);
        chart.setPadding(new RectangleInsets(12, 8, 8, 16));
        BufferedImage image = chart.createBufferedImage(
                WIDTH, MARGIN_HEIGHT + PANEL_HEIGHT * materials.size(), BufferedImage.TYPE_INT_RGB, null);
        PngFile.write(picture, image);
    }

    private static XYPlot panel(CsvTable csv, String material, List<String> integrators) {
        double[] nodes = csv.numbers("nodes");
        List<String> materials = csv.texts("material");
        double most = 0;
        for (int i = 0; i < nodes.length; i++) {
            most = materials.get(i).equals(material) ? Math.max(most, nodes[i]) : most;
        }
        List<Point> points = new ArrayList<>();
        String resolution = "";
        for (int i = 0; i < nodes.length; i++) {
            if (materials.get(i).equals(material) && nodes[i] == most) {
                resolution = csv.texts("resolution").get(i);
                points.add(new Point(
                        csv.texts("integrator").get(i),
                        label(csv, i),
                        csv.numbers("cpu_s")[i],
                        csv.numbers("rms_percent")[i],
                        csv.texts("front").get(i).equals("true"),
                        csv.texts("usual").get(i).equals("true")));
            }
        }
        XYPlot plot = new XYPlot();
        double aim = material.equals("paper") ? PAPER_TARGET_PERCENT : PHYSICAL_TARGET_PERCENT;
        double low = points.stream().mapToDouble(Point::percent).min().orElse(aim);
        double high = points.stream().mapToDouble(Point::percent).max().orElse(aim);
        plot.setRangeAxis(new DecadeAxis(
                material + " preset, " + resolution + " resolution: rms error of the diaphragm, % of excursion",
                Math.min(low, aim) / 2,
                Math.max(high, aim) * 2));
        drawParetoFront(plot, points);
        drawSettings(plot, points, integrators);
        drawTargetLine(plot, aim);
        plot.setBackgroundPaint(new Color(0xf7f8f9));
        plot.setRangeGridlinePaint(new Color(0xc4cad0));
        plot.setDomainGridlinePaint(new Color(0xc4cad0));
        plot.setOutlineVisible(false);
        return plot;
    }

    private static String label(CsvTable csv, int i) {
        int sweeps = (int) csv.numbers("projection_sweeps")[i];
        return String.format(
                Locale.ROOT,
                "%s %s ms, %d sweep%s, refresh %s ms",
                csv.texts("integrator").get(i),
                milliseconds(csv.numbers("time_step_s")[i]),
                sweeps,
                sweeps == 1 ? "" : "s",
                milliseconds(csv.numbers("refresh_s")[i]));
    }

    private static String milliseconds(double seconds) {
        return String.format(Locale.ROOT, "%.3f", 1000 * seconds).replaceFirst("\\.?0+$", "");
    }

    /** The line that joins what is on the front, named point by point. */
    private static void drawParetoFront(XYPlot plot, List<Point> points) {
        XYSeries line = new XYSeries("front");
        double named = Double.POSITIVE_INFINITY;
        for (Point p : points.stream()
                .filter(Point::onFront)
                .sorted(Comparator.comparingDouble(Point::cpuS))
                .toList()) {
            line.add(p.cpuS, p.percent);
            if (p.percent * MIN_LABEL_RATIO < named) {
                XYTextAnnotation text = new XYTextAnnotation(p.label + "   ", p.cpuS, p.percent);
                text.setFont(font(Font.PLAIN, 12));
                text.setTextAnchor(TextAnchor.TOP_RIGHT);
                text.setPaint(new Color(0x30363c));
                plot.addAnnotation(text);
                named = p.percent;
            }
        }
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
        renderer.setSeriesPaint(0, new Color(0x30363c));
        renderer.setSeriesStroke(0, new BasicStroke(1.6f));
        plot.setDataset(1, new XYSeriesCollection(line));
        plot.setRenderer(1, renderer);
    }

    private static void drawSettings(XYPlot plot, List<Point> points, List<String> integrators) {
        XYSeriesCollection series = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(false, true);
        for (int i = 0; i < integrators.size(); i++) {
            XYSeries one = new XYSeries(integrators.get(i));
            String integrator = integrators.get(i);
            points.stream().filter(p -> p.integrator.equals(integrator)).forEach(p -> one.add(p.cpuS, p.percent));
            series.addSeries(one);
            renderer.setSeriesPaint(i, colour(i));
            renderer.setSeriesShape(i, shape(i));
        }
        XYSeries usual = new XYSeries("default");
        points.stream().filter(Point::isDefault).forEach(p -> usual.add(p.cpuS, p.percent));
        series.addSeries(usual);
        int last = integrators.size();
        renderer.setSeriesShape(last, new Ellipse2D.Double(-11, -11, 22, 22));
        renderer.setSeriesShapesFilled(last, Boolean.FALSE);
        renderer.setSeriesPaint(last, Color.BLACK);
        renderer.setSeriesStroke(last, new BasicStroke(2f));
        renderer.setUseOutlinePaint(false);
        renderer.setSeriesOutlineStroke(last, new BasicStroke(2f));
        plot.setDataset(0, series);
        plot.setRenderer(0, renderer);
    }

    private static void drawTargetLine(XYPlot plot, double percent) {
        ValueMarker marker = new ValueMarker(
                percent,
                new Color(0x9a1b1b),
                new BasicStroke(1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {7, 5}, 0));
        marker.setLabel("aim: " + percent + " %");
        marker.setLabelFont(font(Font.PLAIN, 13));
        marker.setLabelPaint(new Color(0x9a1b1b));
        marker.setLabelBackgroundColor(new Color(0, 0, 0, 0));
        marker.setLabelAnchor(RectangleAnchor.TOP_RIGHT);
        marker.setLabelTextAnchor(TextAnchor.BOTTOM_RIGHT);
        plot.addRangeMarker(marker);
    }

    private static LegendTitle legend(List<String> integrators) {
        LegendItemCollection items = new LegendItemCollection();
        for (int i = 0; i < integrators.size(); i++) {
            items.add(new LegendItem(integrators.get(i), null, null, null, shape(i), colour(i)));
        }
        items.add(new LegendItem(
                "default", null, null, null, new Ellipse2D.Double(-7, -7, 14, 14), new BasicStroke(2f), Color.BLACK));
        LegendTitle legend = new LegendTitle(() -> items);
        legend.setItemFont(font(Font.PLAIN, 14));
        legend.setPosition(RectangleEdge.TOP);
        return legend;
    }

    private static Paint colour(int series) {
        return new Color(COLOURS[series % COLOURS.length]);
    }

    private static Shape shape(int series) {
        return switch (series % 3) {
            case 0 -> new Ellipse2D.Double(-4.5, -4.5, 9, 9);
            case 1 -> new Rectangle2D.Double(-4, -4, 8, 8);
            default -> triangle();
        };
    }

    private static Shape triangle() {
        Path2D path = new Path2D.Double();
        path.moveTo(0, -5.5);
        path.lineTo(5.2, 4);
        path.lineTo(-5.2, 4);
        path.closePath();
        return path;
    }

    private static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
