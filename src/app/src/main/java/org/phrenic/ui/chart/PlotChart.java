package org.phrenic.ui.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import javax.swing.JLabel;
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
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import org.jfree.data.xy.DefaultXYDataset;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.ui.widget.Theme;

/**
 * The chart: curves of one unit share a plot, and the plots share the time axis. A kept breath is drawn in thin dashes
 * over every breath, at the same phases. Colours follow the look and feel.
 */
final class PlotChart {
    private static final float LINE_WIDTH = 1.6f;
    private static final float[] DASH_PATTERN = {6, 4};
    private static final float OVERLAY_WIDTH = 1;
    private static final float[] OVERLAY_DASH = {2, 3};
    private static final double PLOT_GAP = 8;
    /** Faint enough for the curves to keep their contrast. */
    private static final float BAND_ALPHA = 0.35f;

    private static final int DISPLACEMENT_WEIGHT = 3;
    private static final int DEFAULT_WEIGHT = 2;

    /** Points of a curve; more than a screen has columns. */
    private static final int MAX_POINTS = 2400;

    private record Subplot(XYPlot plot, DefaultXYDataset data, List<PlotCurve> curves) {
        String unit() {
            return curves.get(0).unit();
        }
    }

    private final NumberAxis time = new NumberAxis("Time (s)");
    private final CombinedDomainXYPlot plots = new CombinedDomainXYPlot(time);
    private final JFreeChart chart = new JFreeChart(null, null, plots, false);
    private final List<Subplot> subplots = new ArrayList<>();
    private final double[] x = new double[MAX_POINTS];
    private final double[] y = new double[MAX_POINTS];
    private KeptBreath overlay;

    PlotChart() {
        plots.setGap(PLOT_GAP);
        time.setAutoRange(false);
        time.setRange(0, 1);
        time.setLowerMargin(0);
        time.setUpperMargin(0);
        time.setNumberFormatOverride(plainNumbers());
        chart.setPadding(new RectangleInsets(4, 2, 2, 8));
        chart.setAntiAlias(true);
        chart.getRenderingHints().put(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        applyTheme();
    }

    /** Thousands without a comma, as everywhere in the window. */
    private static DecimalFormat plainNumbers() {
        return new DecimalFormat("0.###", DecimalFormatSymbols.getInstance(Locale.ROOT));
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
        subplots.clear();
        Map<String, List<PlotCurve>> byUnit = curves.stream()
                .collect(Collectors.groupingBy(PlotCurve::unit, LinkedHashMap::new, Collectors.toList()));
        byUnit.forEach((unit, group) -> {
            NumberAxis axis = new NumberAxis(unit.equals("1") ? "Turn" : unit);
            axis.setAutoRange(false);
            axis.setStandardTickUnits(new NumberTickUnitSource());
            axis.setAutoTickUnitSelection(true);
            axis.setNumberFormatOverride(plainNumbers());
            DefaultXYDataset data = new DefaultXYDataset();
            XYPlot plot = new XYPlot(data, null, axis, new XYLineAndShapeRenderer(true, false));
            plots.add(plot, unit.equals("mm") ? DISPLACEMENT_WEIGHT : DEFAULT_WEIGHT);
            subplots.add(new Subplot(plot, data, group));
        });
        applyTheme();
    }

    /** Draws a breath over those of the run from the next update on; null for none. */
    void setOverlay(KeptBreath breath) {
        overlay = breath;
    }

    /** Draws the samples of the ring between two times. */
    void update(SampleRingBuffer ring, double from, double to) {
        chart.setNotify(false);
        time.setRange(from, Math.max(to, from + 1e-3));
        List<PhaseBands.Band> bands = PhaseBands.of(ring, from, to);
        for (Subplot subplot : subplots) {
            for (PlotCurve curve : subplot.curves) {
                int count = ring.curve(curve.index(), from, to, x, y);
                double[][] points = {Arrays.copyOf(x, count), Arrays.copyOf(y, count)};
                subplot.data.addSeries(curve.label(), points);
            }
            subplot.curves.forEach(
                    curve -> subplot.data.addSeries(curve.label() + " overlay", overlayPoints(ring, curve, from, to)));
            fitRange(subplot);
            markPhases(subplot.plot, bands);
        }
        chart.setNotify(true);
    }

    /** The overlay at the phases of the samples between two times. */
    private double[][] overlayPoints(SampleRingBuffer ring, PlotCurve curve, double from, double to) {
        if (overlay == null) {
            return new double[2][0];
        }
        int count = ring.curve(KeptBreath.PHASE, from, to, x, y);
        double[] values = new double[count];
        Arrays.setAll(values, i -> overlay.value(curve.index(), y[i]));
        return new double[][] {Arrays.copyOf(x, count), values};
    }

    /** Marks the phases behind the curves in the colours of the timeline; pauses stay plain. */
    private static void markPhases(XYPlot plot, List<PhaseBands.Band> bands) {
        plot.clearDomainMarkers();
        for (PhaseBands.Band band : bands) {
            if (band.label() != RespiratoryPhase.PAUSE) {
                Marker marker = new IntervalMarker(band.from(), band.to(), PhaseColours.of(band.label()));
                marker.setAlpha(BAND_ALPHA);
                plot.addDomainMarker(marker, Layer.BACKGROUND);
            }
        }
    }

    /** Sets a range of round numbers around the values; it shrinks only when half of it is empty, to be steady. */
    private static void fitRange(Subplot subplot) {
        Range values = DatasetUtils.findRangeBounds(subplot.data);
        if (values == null) {
            return;
        }
        double least = values.getLowerBound();
        double span = Math.max(values.getLength(), minSpan(subplot.unit()));
        double round = Math.pow(10, Math.floor(Math.log10(span / 4)));
        double low = Math.floor((least - 0.03 * span) / round) * round;
        double high = Math.ceil((least + 1.03 * span) / round) * round;
        ValueAxis axis = subplot.plot.getRangeAxis();
        boolean outside = axis.getLowerBound() > least || axis.getUpperBound() < values.getUpperBound();
        if (outside || axis.getRange().getLength() > 2 * (high - low)) {
            axis.setRange(low, high);
        }
    }

    private static double minSpan(String unit) {
        return switch (unit) {
            case "ml" -> 10;
            case "1" -> 0.05;
            default -> 1;
        };
    }

    /** Takes over the colours and fonts of the look and feel. */
    void applyTheme() {
        boolean dark = Theme.isDark();
        Color back = uiColour("Panel.background", Color.WHITE);
        Color text = uiColour("Label.foreground", Color.BLACK);
        Color paper = dark ? back.darker() : Color.WHITE;
        Color grid = dark ? new Color(255, 255, 255, 36) : new Color(0, 0, 0, 32);
        Font font = new JLabel().getFont();
        chart.setBackgroundPaint(back);
        plots.setBackgroundPaint(back);
        styleAxis(time, text, font);
        for (Subplot subplot : subplots) {
            XYPlot plot = subplot.plot;
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
            int count = subplot.curves.size();
            for (int k = 0; k < count; k++) {
                renderer.setSeriesPaint(count + k, subplot.curves.get(k).colour());
                renderer.setSeriesStroke(count + k, dashes(OVERLAY_WIDTH, OVERLAY_DASH));
                renderer.setSeriesPaint(k, subplot.curves.get(k).colour());
                renderer.setSeriesStroke(k, stroke(subplot.curves.get(k)));
            }
        }
    }

    static Stroke stroke(PlotCurve curve) {
        return curve.dashed()
                ? dashes(LINE_WIDTH, DASH_PATTERN)
                : new BasicStroke(LINE_WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    private static Stroke dashes(float width, float[] pattern) {
        return new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, pattern, 0);
    }

    private static void styleAxis(ValueAxis axis, Color text, Font font) {
        axis.setLabelPaint(text);
        axis.setTickLabelPaint(text);
        axis.setLabelFont(font.deriveFont(font.getSize2D() - 1));
        axis.setTickLabelFont(font.deriveFont(font.getSize2D() - 1));
        axis.setAxisLinePaint(text);
        axis.setTickMarkPaint(text);
    }

    private static Color uiColour(String key, Color absent) {
        Color found = UIManager.getColor(key);
        return found == null ? absent : new Color(found.getRGB(), true);
    }
}
