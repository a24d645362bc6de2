package org.phrenic.ui.chart;

import java.util.Arrays;

/**
 * The last samples of some columns over time, the oldest of which make way for new ones. Arrays are made once: adding
 * allocates nothing. Used by the event thread alone.
 */
final class SampleRingBuffer {
    private final double[] times;
    private final double[][] columns;
    private int first;
    private int size;

    /**
     * @param columns values of a sample
     * @param capacity samples that are kept
     */
    SampleRingBuffer(int columns, int capacity) {
        times = new double[capacity];
        this.columns = new double[columns][capacity];
    }

    /** Adds a sample; one that is not later than the last begins a new record. Values that are missing are NaN. */
    void add(double time, double[] values) {
        if (size > 0 && time <= time(size - 1)) {
            clear();
        }
        int at = index(size);
        if (size == times.length) {
            first = (first + 1) % times.length;
        } else {
            size++;
        }
        times[at] = time;
        for (int c = 0; c < columns.length; c++) {
            columns[c][at] = c < values.length ? values[c] : Double.NaN;
        }
    }

    /** Sets a value of a sample. */
    void set(int column, int sample, double value) {
        columns[column][index(sample)] = value;
    }

    /** Forgets one column, as if it had never been sampled. */
    void clearColumn(int column) {
        Arrays.fill(columns[column], Double.NaN);
    }

    void clear() {
        first = 0;
        size = 0;
    }

    int size() {
        return size;
    }

    /** Time of a sample, the oldest first. */
    double time(int sample) {
        return times[index(sample)];
    }

    double value(int column, int sample) {
        return columns[column][index(sample)];
    }

    private int index(int sample) {
        return (first + sample) % times.length;
    }

    /** First sample at or after a time; {@link #size} if there is none. */
    int firstFrom(double time) {
        int low = 0;
        int high = size;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (time(middle) < time) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Sample nearest to a time; -1 if there is none. */
    int nearest(double time) {
        int after = firstFrom(time);
        if (after == size) {
            return size - 1;
        }
        return after > 0 && time - time(after - 1) < time(after) - time ? after - 1 : after;
    }

    /**
     * The curve of a column between two times in no more points than can be drawn. Samples without a value are left
     * out; where there are more samples than points, each stretch of them leaves its least and its greatest value, so
     * that no peak is lost.
     *
     * @param x gets times
     * @param y gets values; as long as {@code x}
     * @return points written
     */
    int curve(int column, double from, double to, double[] x, double[] y) {
        int begin = Math.max(0, firstFrom(from) - 1);
        int end = Math.min(size, firstFrom(to) + 1);
        int count = end - begin;
        int stretches = count <= x.length ? count : x.length / 2;
        int written = 0;
        for (int s = 0; s < stretches; s++) {
            int low = begin + (int) ((long) count * s / stretches);
            int high = begin + (int) ((long) count * (s + 1) / stretches);
            written += extremes(column, low, high, written, x, y);
        }
        return written;
    }

    /**
     * Writes the least and the greatest value of a stretch, the earlier first; one point if they are the same, none if
     * it has no values.
     */
    private int extremes(int column, int low, int high, int at, double[] x, double[] y) {
        int least = -1;
        int greatest = -1;
        for (int i = low; i < high; i++) {
            double value = value(column, i);
            if (Double.isNaN(value)) {
                continue;
            }
            least = least < 0 || value < value(column, least) ? i : least;
            greatest = greatest < 0 || value > value(column, greatest) ? i : greatest;
        }
        if (least < 0) {
            return 0;
        }
        int earlier = Math.min(least, greatest);
        int later = Math.max(least, greatest);
        x[at] = time(earlier);
        y[at] = value(column, earlier);
        if (earlier == later) {
            return 1;
        }
        x[at + 1] = time(later);
        y[at + 1] = value(column, later);
        return 2;
    }
}
