package org.phrenic.cli.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYTitleAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.document.CsvTable;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.scene.export.PngFile;

/** The curves of a run as one picture: domes, lung volume, diameters of the chest, sternum. */
public final class RunChart {
    private static final int WIDTH = 1200;
    private static final int HEIGHT = 1100;

    /** Colours that any colour vision tells apart (Okabe and Ito 2008). */
    private static final int[] COLOURS = {0x0072b2, 0xd55e00, 0x009e73};

    private RunChart() {}

    /**
     * Draws the columns of an {@code observables.csv}.
     *
     * @param title above the curves
     * @throws org.phrenic.format.BadInputException if a column is missing
     */
    public static void write(Path observables, String title, Path picture) {
        System.setProperty("java.awt.headless", "true");
        CsvTable table = CsvTable.read(observables);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(axis("time, s"));
        all.setGap(14);
        all.add(panel(
                table,
                "domes, up, mm",
                "dome_right_mm",
                "right",
                "dome_left_mm",
                "left",
                "central_tendon_mm",
                "centre"));
        all.add(panel(table, "lung volume, ml", "lung_volume_change_ml", "change"));
        all.add(panel(
                table,
                "chest wall, mm",
                "ap_change_mm",
                "anteroposterior",
                "transverse_change_mm",
                "transverse",
                "sternum_cranial_mm",
                "sternum, up"));
        all.add(panel(table, "liver, mm", "liver_si_mm", "up", "liver_ap_mm", "back", "liver_lr_mm", "to the left"));
        JFreeChart chart = new JFreeChart(title, font(Font.PLAIN, 19), all, false);
        chart.setBackgroundPaint(Color.WHITE);
        TextTitle notice = new TextTitle(Disclaimer.TEXT, font(Font.PLAIN, 13));
        notice.setPosition(RectangleEdge.BOTTOM);
        notice.setHorizontalAlignment(HorizontalAlignment.LEFT);
        chart.addSubtitle(notice);
        chart.setPadding(new RectangleInsets(10, 6, 8, 12));
        BufferedImage image = chart.createBufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB, null);
        PngFile.write(picture, image);
    }

    private static XYPlot panel(CsvTable table, String label, String... columnsAndNames) {
        double[] time = table.numbers("time_s");
        XYSeriesCollection curves = new XYSeriesCollection();
        XYLineAndShapeRenderer lines = new XYLineAndShapeRenderer(true, false);
        for (int i = 0; i < columnsAndNames.length; i += 2) {
            double[] values = table.numbers(columnsAndNames[i]);
            XYSeries series = new XYSeries(columnsAndNames[i + 1]);
            for (int row = 0; row < time.length; row++) {
                series.add(time[row], values[row]);
            }
            curves.addSeries(series);
            lines.setSeriesPaint(i / 2, new Color(COLOURS[i / 2]));
            lines.setSeriesStroke(i / 2, new BasicStroke(2.2f));
        }
        XYPlot plot = new XYPlot(curves, null, axis(label), lines);
        plot.setBackgroundPaint(new Color(0xf7f8f9));
        plot.setRangeGridlinePaint(new Color(0xc4cad0));
        plot.setDomainGridlinePaint(new Color(0xc4cad0));
        plot.setOutlineVisible(false);
        LegendTitle names = new LegendTitle(plot);
        names.setItemFont(font(Font.PLAIN, 13));
        names.setBackgroundPaint(new Color(255, 255, 255, 220));
        // Away from the curves, which end at rest: above those that go up, below those that go down.
        boolean upward = curves.getRangeUpperBound(false) > -curves.getRangeLowerBound(false);
        plot.addAnnotation(new XYTitleAnnotation(
                0.995, upward ? 0.97 : 0.03, names, upward ? RectangleAnchor.TOP_RIGHT : RectangleAnchor.BOTTOM_RIGHT));
        return plot;
    }

    private static NumberAxis axis(String label) {
        NumberAxis axis = new NumberAxis(label);
        axis.setLabelFont(font(Font.PLAIN, 15));
        axis.setTickLabelFont(font(Font.PLAIN, 13));
        axis.setAutoRangeIncludesZero(true);
        return axis;
    }

    private static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
