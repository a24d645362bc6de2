package org.phrenic.study.sweep.report;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.report.ReportDocument.Picture;

/** Horizontal bars with error bars, one group of bars a factor. */
final class BarChart {
    private static final double WIDTH = 640;
    private static final double LEFT = 190;
    private static final double RIGHT = 20;
    private static final double BAR = 13;
    private static final double GAP = 8;
    private static final double TOP = 8;
    private static final double BOTTOM = 40;

    /**
     * A bar.
     *
     * @param from one end
     * @param to other end
     * @param low lower end of the error bar; NaN for none
     * @param high upper end of the error bar; NaN for none
     */
    record Bar(double from, double to, double low, double high) {}

    private final String unit;
    private final List<String> names = new ArrayList<>();
    private final List<List<Bar>> groups = new ArrayList<>();

    /** @param unit label of the axis */
    BarChart(String unit) {
        this.unit = unit;
    }

    void add(String name, Bar... bars) {
        names.add(name);
        groups.add(List.of(bars));
    }

    Picture picture(String alternative, String caption) {
        double height = TOP + BOTTOM;
        List<Double> values = new ArrayList<>();
        for (List<Bar> group : groups) {
            height += group.size() * BAR + GAP;
            group.forEach(bar -> values.addAll(List.of(bar.from, bar.to, bar.low, bar.high)));
        }
        PlotAxis axis = PlotAxis.around(
                LEFT,
                WIDTH - RIGHT,
                values.stream().mapToDouble(Double::doubleValue).toArray());
        SvgCanvas svg = new SvgCanvas(WIDTH, height);
        for (double tick : axis.ticks()) {
            svg.line(axis.at(tick), TOP, axis.at(tick), height - BOTTOM, SvgCanvas.PALE);
            svg.label(axis.at(tick), height - BOTTOM + 15, "middle", axis.text(tick));
        }
        double y = TOP;
        for (int g = 0; g < groups.size(); g++) {
            List<Bar> group = groups.get(g);
            svg.label(LEFT - 8, y + group.size() * BAR / 2 + 4, "end", names.get(g));
            for (int b = 0; b < group.size(); b++) {
                draw(svg, axis, group.get(b), y, b == 0 ? SvgCanvas.FIRST : SvgCanvas.SECOND);
                y += BAR;
            }
            y += GAP;
        }
        svg.label((LEFT + WIDTH - RIGHT) / 2, height - 8, "middle", unit);
        return new Picture(svg.dataUrl(), alternative, caption);
    }

    private static void draw(SvgCanvas svg, PlotAxis axis, Bar bar, double y, String colour) {
        if (!Double.isFinite(bar.from) || !Double.isFinite(bar.to)) {
            return;
        }
        double left = axis.at(Math.min(bar.from, bar.to));
        svg.bar(left, y, Math.max(1, axis.at(Math.max(bar.from, bar.to)) - left), BAR - 2, colour);
        if (Double.isFinite(bar.low) && Double.isFinite(bar.high)) {
            double middle = y + (BAR - 2) / 2;
            svg.polyline(
                    new double[] {axis.at(bar.low), axis.at(bar.high)},
                    new double[] {middle, middle},
                    SvgCanvas.INK,
                    2);
        }
    }
}
