package org.phrenic.cli.chart;

import java.awt.Color;
import java.nio.file.Path;
import org.jfree.chart.annotations.XYTitleAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.phrenic.document.CsvTable;

/** A chart of the curves of a run: domes, lung volume, chest diameters, sternum, liver. */
public final class RunChart {
    private static final int HEIGHT = 1100;

    private RunChart() {}

    /**
     * Draws the columns of an {@code observables.csv}.
     *
     * @param title title of the chart
     * @throws org.phrenic.file.BadInputException if a column is missing
     */
    public static void write(Path observables, String title, Path picture) {
        System.setProperty("java.awt.headless", "true");
        CsvTable table = CsvTable.read(observables);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(ChartStyle.axis(new NumberAxis("time, s")));
        all.setGap(14);
        String[][] panels = {
            {"domes, up, mm", "dome_right_mm", "right", "dome_left_mm", "left", "central_tendon_mm", "centre"},
            {"lung volume, ml", "lung_volume_change_ml", "change"},
            {
                "chest wall, mm",
                "ap_change_mm",
                "anteroposterior",
                "transverse_change_mm",
                "transverse",
                "sternum_cranial_mm",
                "sternum, up"
            },
            {"liver, mm", "liver_si_mm", "up", "liver_ap_mm", "back", "liver_lr_mm", "to the left"}
        };
        for (String[] panel : panels) {
            all.add(panel(table, panel));
        }
        ChartStyle.write(picture, ChartStyle.chart(title, all), HEIGHT);
    }

    /** @param panel axis label, followed by pairs of column name and curve name */
    private static XYPlot panel(CsvTable table, String... panel) {
        double[] time = table.numbers("time_s");
        XYSeriesCollection curves = new XYSeriesCollection();
        XYLineAndShapeRenderer lines = new XYLineAndShapeRenderer(true, false);
        for (int i = 1; i < panel.length; i += 2) {
            double[] values = table.numbers(panel[i]);
            XYSeries series = new XYSeries(panel[i + 1]);
            for (int row = 0; row < time.length; row++) {
                series.add(time[row], values[row]);
            }
            curves.addSeries(series);
            ChartStyle.line(i / 2, ChartStyle.colour(i / 2), 2.2f, lines);
        }
        XYPlot plot = ChartStyle.panel(new XYPlot(curves, null, ChartStyle.axis(new NumberAxis(panel[0])), lines));
        LegendTitle names = new LegendTitle(plot);
        names.setItemFont(ChartStyle.font(13));
        names.setBackgroundPaint(new Color(255, 255, 255, 220));
        // Places the legend clear of the curves: on top if they rise, at the bottom if they fall.
        boolean upward = curves.getRangeUpperBound(false) > -curves.getRangeLowerBound(false);
        plot.addAnnotation(new XYTitleAnnotation(
                0.995, upward ? 0.97 : 0.03, names, upward ? RectangleAnchor.TOP_RIGHT : RectangleAnchor.BOTTOM_RIGHT));
        return plot;
    }
}
