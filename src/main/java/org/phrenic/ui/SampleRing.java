package org.phrenic.ui;

import java.util.Arrays;

/**
 * The last samples of some columns over time, the oldest of which make way for new ones. Arrays are made once: adding allocates nothing. Used by the event thread alone.
 */
final class SampleRing {
    private final double[] times;
    private final double[][] columns;
    private int first;
    private int size;

    /**
     * @param columns values of a sample
     * @param capacity samples that are kept
     */
    SampleRing(int columns, int capacity) {
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

    /** Sets a value of the newest sample. */
    void setLast(int column, double value) {
        columns[column][index(size - 1)] = value;
    }

    /** Forgets one column, as if it had never been sampled. */
    void forget(int column) {
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
     * The curve of a column between two times in no more points than can be drawn. Where there are more samples, each stretch of them leaves its least and its greatest value, so that no peak is lost.
     *
     * @param x gets times
     * @param y gets values; as long as {@code x}
     * @return points written
     */
    int curve(int column, double from, double to, double[] x, double[] y) {
        int begin = Math.max(0, firstFrom(from) - 1);
        int end = Math.min(size, firstFrom(to) + 1);
        int count = end - begin;
        if (count <= x.length) {
            for (int i = 0; i < count; i++) {
                x[i] = time(begin + i);
                y[i] = value(column, begin + i);
            }
            return count;
        }
        int stretches = x.length / 2;
        for (int s = 0; s < stretches; s++) {
            int low = begin + (int) ((long) count * s / stretches);
            int high = begin + (int) ((long) count * (s + 1) / stretches);
            extremes(column, low, high, 2 * s, x, y);
        }
        return 2 * stretches;
    }

    private void extremes(int column, int low, int high, int at, double[] x, double[] y) {
        int least = low;
        int greatest = low;
        for (int i = low + 1; i < high; i++) {
            if (value(column, i) < value(column, least)) {
                least = i;
            }
            if (value(column, i) > value(column, greatest)) {
                greatest = i;
            }
        }
        int earlier = Math.min(least, greatest);
        int later = Math.max(least, greatest);
        x[at] = time(earlier);
        y[at] = value(column, earlier);
        x[at + 1] = time(later);
        y[at + 1] = value(column, later);
    }
}
