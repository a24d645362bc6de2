package org.phrenic.ui.chart;

import java.util.List;
import org.jfree.data.xy.AbstractXYDataset;

/**
 * The curves of one plot as they are drawn: points of a {@link SampleRingBuffer} between two times, copied into arrays
 * that are made once.
 */
final class PlotDataset extends AbstractXYDataset {
    /** Points a curve, more than a screen has columns. */
    static final int MAX_POINTS_PER_CURVE = 2400;

    private final transient List<PlotCurve> curves;
    private final transient double[][] x;
    private final transient double[][] y;
    private final transient int[] counts;

    PlotDataset(List<PlotCurve> curves) {
        this.curves = List.copyOf(curves);
        x = new double[curves.size()][MAX_POINTS_PER_CURVE];
        y = new double[curves.size()][MAX_POINTS_PER_CURVE];
        counts = new int[curves.size()];
    }

    List<PlotCurve> curves() {
        return curves;
    }

    /** Takes what the ring has between two times, and has it drawn. */
    void update(SampleRingBuffer ring, double from, double to) {
        for (int i = 0; i < counts.length; i++) {
            counts[i] = ring.curve(curves.get(i).index(), from, to, x[i], y[i]);
        }
        fireDatasetChanged();
    }

    /** Least and greatest value shown; null if there is none. */
    double[] range() {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < counts.length; i++) {
            for (int k = 0; k < counts[i]; k++) {
                if (Double.isFinite(y[i][k])) {
                    least = Math.min(least, y[i][k]);
                    greatest = Math.max(greatest, y[i][k]);
                }
            }
        }
        return least <= greatest ? new double[] {least, greatest} : null;
    }

    @Override
    public int getSeriesCount() {
        return curves.size();
    }

    @Override
    public Comparable<?> getSeriesKey(int series) {
        return curves.get(series).label();
    }

    @Override
    public int getItemCount(int series) {
        return counts[series];
    }

    @Override
    public Number getX(int series, int item) {
        return x[series][item];
    }

    @Override
    public Number getY(int series, int item) {
        return y[series][item];
    }

    @Override
    public double getXValue(int series, int item) {
        return x[series][item];
    }

    @Override
    public double getYValue(int series, int item) {
        return y[series][item];
    }
}
