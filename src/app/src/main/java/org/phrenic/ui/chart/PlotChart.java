package org.phrenic.ui.chart;

import com.formdev.flatlaf.FlatLaf;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.UIManager;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.plot.Marker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleInsets;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * The chart: curves of one unit share a plot and its axis, plots stand above one another over one axis of time. Colours
 * are those of the look and feel.
 */
final class PlotChart {
    private static final float LINE_WIDTH = 1.6f;
    private static final float[] DASH_PATTERN = {6, 4};
    private static final double PLOT_GAP = 8;
    /** Faint enough for the curves to keep their contrast. */
    private static final float BAND_ALPHA = 0.35f;

    private static final int DISPLACEMENT_WEIGHT = 3;
    private static final int DEFAULT_WEIGHT = 2;

    private final NumberAxis time = new NumberAxis("Time (s)");
    private final CombinedDomainXYPlot plots = new CombinedDomainXYPlot(time);
    private final JFreeChart chart = new JFreeChart(null, null, plots, false);
    private final List<PlotDataset> datasets = new ArrayList<>();

    PlotChart() {
        plots.setGap(PLOT_GAP);
        time.setAutoRange(false);
        time.setRange(0, 1);
        time.setLowerMargin(0);
        time.setUpperMargin(0);
        chart.setPadding(new RectangleInsets(4, 2, 2, 8));
        chart.setAntiAlias(true);
        chart.getRenderingHints().put(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        applyTheme();
    }

    JFreeChart chart() {
        return chart;
    }

    ValueAxis timeAxis() {
        return time;
    }

    /** Shows these curves and no others. */
    void setCurves(List<PlotCurve> curves) {
        new ArrayList<>(plots.getSubplots()).forEach(plots::remove);
        datasets.clear();
        Map<String, List<PlotCurve>> byUnit = new LinkedHashMap<>();
        curves.forEach(
                c -> byUnit.computeIfAbsent(c.unit(), unit -> new ArrayList<>()).add(c));
        byUnit.forEach((unit, group) -> {
            PlotDataset own = new PlotDataset(group);
            NumberAxis axis = new NumberAxis(axisLabel(unit));
            axis.setAutoRange(false);
            axis.setStandardTickUnits(new NumberTickUnitSource());
            axis.setAutoTickUnitSelection(true);
            axis.setNumberFormatOverride(new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT)));
            XYPlot plot = new XYPlot(own, null, axis, new XYLineAndShapeRenderer(true, false));
            plots.add(plot, unit.equals("mm") ? DISPLACEMENT_WEIGHT : DEFAULT_WEIGHT);
            datasets.add(own);
        });
        applyTheme();
    }

    private static String axisLabel(String unit) {
        return switch (unit) {
            case "mm" -> "mm";
            case "ml" -> "ml";
            case "%" -> "%";
            default -> "Turn";
        };
    }

    /** Draws what the ring has between two times. */
    void update(SampleRingBuffer ring, double from, double to) {
        chart.setNotify(false);
        time.setRange(from, Math.max(to, from + 1e-3));
        for (int i = 0; i < datasets.size(); i++) {
            datasets.get(i).update(ring, from, to);
            fitRange((NumberAxis) plots.getSubplots().get(i).getRangeAxis(), datasets.get(i));
        }
        markPhases(PhaseBands.of(ring, from, to));
        chart.setNotify(true);
    }

    /** Bands behind the curves of what the breath did, in the colours of the timeline; pauses stay plain. */
    private void markPhases(List<PhaseBands.Band> bands) {
        for (Object subplot : plots.getSubplots()) {
            XYPlot plot = (XYPlot) subplot;
            plot.clearDomainMarkers();
            for (PhaseBands.Band band : bands) {
                if (band.label() != RespiratoryPhase.PAUSE) {
                    Marker marker = new IntervalMarker(band.from(), band.to(), PhaseColours.of(band.label()));
                    marker.setAlpha(BAND_ALPHA);
                    plot.addDomainMarker(marker, Layer.BACKGROUND);
                }
            }
        }
    }

    /**
     * A range of round numbers around the values; it grows at once and shrinks only when half of it stands empty, so
     * that it does not tremble.
     */
    private static void fitRange(NumberAxis axis, PlotDataset values) {
        double[] seen = values.range();
        if (seen == null) {
            return;
        }
        double span = Math.max(seen[1] - seen[0], minSpan(values));
        double round = Math.pow(10, Math.floor(Math.log10(span / 4)));
        double low = Math.floor((seen[0] - 0.03 * span) / round) * round;
        double high = Math.ceil((seen[0] + 1.03 * span) / round) * round;
        boolean outside = axis.getLowerBound() > seen[0] || axis.getUpperBound() < seen[1];
        boolean empty = axis.getRange().getLength() > 2 * (high - low);
        if (outside || empty) {
            axis.setRange(low, high);
        }
    }

    private static double minSpan(PlotDataset values) {
        return switch (values.curves().get(0).unit()) {
            case "ml" -> 10;
            case "1" -> 0.05;
            default -> 1;
        };
    }

    /** Takes over the colours and fonts of the look and feel. */
    void applyTheme() {
        boolean dark = FlatLaf.isLafDark();
        Color back = colour("Panel.background", Color.WHITE);
        Color text = colour("Label.foreground", Color.BLACK);
        Color paper = dark ? back.darker() : Color.WHITE;
        Color grid = dark ? new Color(255, 255, 255, 36) : new Color(0, 0, 0, 32);
        Font font = UIManager.getFont("Label.font") == null
                ? new Font(Font.SANS_SERIF, Font.PLAIN, 12)
                : UIManager.getFont("Label.font");
        chart.setBackgroundPaint(back);
        plots.setBackgroundPaint(back);
        styleAxis(time, text, font);
        for (int i = 0; i < datasets.size(); i++) {
            XYPlot plot = plots.getSubplots().get(i);
            plot.setBackgroundPaint(paper);
            plot.setOutlinePaint(grid);
            plot.setDomainGridlinePaint(grid);
            plot.setRangeGridlinePaint(grid);
            plot.setDomainGridlineStroke(new BasicStroke(1));
            plot.setRangeGridlineStroke(new BasicStroke(1));
            plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
            styleAxis(plot.getRangeAxis(), text, font);
            XYLineAndShapeRenderer renderer = (XYLineAndShapeRenderer) plot.getRenderer();
            renderer.setDrawSeriesLineAsPath(true);
            List<PlotCurve> curves = datasets.get(i).curves();
            for (int k = 0; k < curves.size(); k++) {
                renderer.setSeriesPaint(k, curves.get(k).colour(dark));
                renderer.setSeriesStroke(k, stroke(curves.get(k)));
            }
        }
    }

    /** How a curve is drawn. */
    static Stroke stroke(PlotCurve curve) {
        return curve.dashed()
                ? new BasicStroke(LINE_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, DASH_PATTERN, 0)
                : new BasicStroke(LINE_WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    private static void styleAxis(ValueAxis axis, Color text, Font font) {
        axis.setLabelPaint(text);
        axis.setTickLabelPaint(text);
        axis.setLabelFont(font.deriveFont(font.getSize2D() - 1));
        axis.setTickLabelFont(font.deriveFont(font.getSize2D() - 1));
        axis.setAxisLinePaint(text);
        axis.setTickMarkPaint(text);
    }

    private static Color colour(String key, Color absent) {
        Color found = UIManager.getColor(key);
        return found == null ? absent : new Color(found.getRGB(), true);
    }
}
