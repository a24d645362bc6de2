package org.phrenic.study.sweep.report;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.report.ReportDocument.Picture;

/** Curves, bands and points over two axes. */
final class CurveChart {
    private static final double LEFT = 62;
    private static final double RIGHT = 14;
    private static final double TOP = 10;
    private static final double BOTTOM = 42;

    private record Layer(double[] x, double[] low, double[] high, boolean dots) {}

    private final double width;
    private final double height;
    private final String label;
    private final List<Layer> layers = new ArrayList<>();
    private List<String> names = List.of();

    /** @param label of the horizontal axis */
    CurveChart(double width, double height, String label) {
        this.width = width;
        this.height = height;
        this.label = label;
    }

    /** Shows names in place of the numbers 0, 1, ... */
    CurveChart named(List<String> values) {
        names = values;
        return this;
    }

    CurveChart curve(double[] x, double[] y, boolean dots) {
        layers.add(new Layer(x, y, y, dots));
        return this;
    }

    CurveChart band(double[] x, double[] low, double[] high) {
        layers.add(new Layer(x, low, high, false));
        return this;
    }

    Picture picture(String alternative, String caption) {
        PlotAxis across = PlotAxis.around(LEFT, width - RIGHT, all(true));
        PlotAxis up = PlotAxis.around(height - BOTTOM, TOP, all(false));
        SvgCanvas svg = new SvgCanvas(width, height);
        for (double tick : up.ticks()) {
            svg.line(LEFT, up.at(tick), width - RIGHT, up.at(tick), SvgCanvas.PALE);
            svg.label(LEFT - 5, up.at(tick) + 4, "end", up.text(tick));
        }
        if (names.isEmpty()) {
            across.ticks().forEach(tick -> mark(svg, across.at(tick), across.text(tick)));
        }
        for (int i = 0; i < names.size(); i++) {
            mark(svg, across.at(i), names.get(i));
        }
        for (int i = 0; i < layers.size(); i++) {
            draw(svg, across, up, layers.get(i), i == 0 ? SvgCanvas.WIDE_BAND : SvgCanvas.NARROW_BAND);
        }
        svg.label((LEFT + width - RIGHT) / 2, height - 8, "middle", label);
        return new Picture(svg.dataUrl(), alternative, caption);
    }

    /** A line up from a place of the axis across, and what stands there. */
    private void mark(SvgCanvas svg, double at, String text) {
        svg.line(at, TOP, at, height - BOTTOM, SvgCanvas.PALE);
        svg.label(at, height - BOTTOM + 15, "middle", text);
    }

    private static void draw(SvgCanvas svg, PlotAxis across, PlotAxis up, Layer layer, String bandColour) {
        double[] x = across.at(layer.x);
        double[] high = up.at(layer.high);
        if (layer.low != layer.high) {
            double[] low = up.at(layer.low);
            int n = x.length;
            double[] ringX = new double[2 * n];
            double[] ringY = new double[2 * n];
            for (int i = 0; i < n; i++) {
                ringX[i] = x[i];
                ringY[i] = high[i];
                ringX[2 * n - 1 - i] = x[i];
                ringY[2 * n - 1 - i] = low[i];
            }
            svg.area(ringX, ringY, bandColour);
            return;
        }
        if (!layer.dots) {
            svg.polyline(x, high, SvgCanvas.FIRST, 2);
            return;
        }
        for (int i = 0; i < x.length; i++) {
            svg.dot(x[i], high[i], SvgCanvas.FIRST);
        }
    }

    private double[] all(boolean horizontal) {
        return layers.stream()
                .flatMapToDouble(layer -> horizontal
                        ? java.util.Arrays.stream(layer.x)
                        : java.util.stream.DoubleStream.concat(
                                java.util.Arrays.stream(layer.low), java.util.Arrays.stream(layer.high)))
                .toArray();
    }
}
