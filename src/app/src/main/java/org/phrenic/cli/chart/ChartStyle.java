package org.phrenic.cli.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.scene.export.PngFile;

/** Common fonts, colours, disclaimer and file output of the charts. */
final class ChartStyle {
    private static final int WIDTH = 1200;
    private static final float RING_WIDTH = 2;
    /** Colours of Okabe and Ito 2008, distinguishable with colour vision deficiency. */
    private static final int[] COLOURS = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x8a6d00, 0x56b4e9};

    private ChartStyle() {}

    static Font font(int size) {
        return new Font(Font.SANS_SERIF, Font.PLAIN, size);
    }

    static Paint colour(int series) {
        return new Color(COLOURS[series % COLOURS.length]);
    }

    static <A extends ValueAxis> A axis(A axis) {
        axis.setLabelFont(font(15));
        axis.setTickLabelFont(font(13));
        return axis;
    }

    static XYLineAndShapeRenderer line(int series, Paint colour, float width, XYLineAndShapeRenderer renderer) {
        renderer.setSeriesPaint(series, colour);
        renderer.setSeriesStroke(series, new BasicStroke(width));
        return renderer;
    }

    /** Draws the points of a series as rings. */
    static void rings(int series, Shape ring, XYLineAndShapeRenderer renderer) {
        line(series, Color.BLACK, RING_WIDTH, renderer);
        renderer.setSeriesShape(series, ring);
        renderer.setSeriesShapesFilled(series, Boolean.FALSE);
        renderer.setSeriesOutlineStroke(series, new BasicStroke(RING_WIDTH));
    }

    /** A legend above the panels, which ends with the ring about the defaults. */
    static LegendTitle legend(LegendItemCollection items, Shape ring) {
        items.add(new LegendItem("default", null, null, null, ring, new BasicStroke(RING_WIDTH), Color.BLACK));
        LegendTitle legend = new LegendTitle(() -> items);
        legend.setItemFont(font(14));
        legend.setPosition(RectangleEdge.TOP);
        return legend;
    }

    static XYPlot panel(XYPlot plot) {
        plot.setBackgroundPaint(new Color(0xf7f8f9));
        plot.setRangeGridlinePaint(new Color(0xc4cad0));
        plot.setDomainGridlinePaint(new Color(0xc4cad0));
        plot.setOutlineVisible(false);
        return plot;
    }

    static JFreeChart chart(String title, CombinedDomainXYPlot panels) {
        JFreeChart chart = new JFreeChart(title, font(20), panels, false);
        chart.setBackgroundPaint(Color.WHITE);
        chart.setPadding(new RectangleInsets(12, 8, 8, 16));
        TextTitle disclaimer = new TextTitle(Disclaimer.TEXT, font(13));
        disclaimer.setPosition(RectangleEdge.BOTTOM);
        disclaimer.setHorizontalAlignment(HorizontalAlignment.LEFT);
        chart.addSubtitle(disclaimer);
        return chart;
    }

    static void write(Path picture, JFreeChart chart, int height) {
        PngFile.write(picture, chart.createBufferedImage(WIDTH, height, BufferedImage.TYPE_INT_RGB, null));
    }
}
