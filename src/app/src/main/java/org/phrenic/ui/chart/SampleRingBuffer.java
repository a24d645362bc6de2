package org.phrenic.ui.chart;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.simulation.live.RunHistory;

/** The last samples of some columns over time. Adding a sample allocates nothing. Used on the event dispatch thread. */
final class SampleRingBuffer {
    private final double[] times;
    private final double[][] columns;
    private int first;
    private int size;
    private long samplesRead;

    /** @param capacity samples that are kept */
    SampleRingBuffer(int columns, int capacity) {
        times = new double[capacity];
        this.columns = new double[columns][capacity];
    }

    /** Adds a sample; one that is not later than the last clears those before. Missing values become NaN. */
    void add(double time, double[] values) {
        if (size > 0 && time <= time(size - 1)) {
            first = 0;
            size = 0;
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

    /**
     * Reads the samples that a history has gained; all of them after a restart of the run.
     *
     * @param history null before the first scene
     * @return whether there are new samples
     */
    boolean update(RunHistory history) {
        if (history == null) {
            return false;
        }
        // The simulation's thread adds samples and drops the oldest meanwhile.
        synchronized (history) {
            int count = history.size();
            long total = history.dropped() + count;
            boolean restarted =
                    total < samplesRead || (count > 0 && size > 0 && history.time(count - 1) < time(size - 1));
            if (restarted) {
                clear();
            }
            for (int i = (int) Math.max(0, samplesRead - history.dropped()); i < count; i++) {
                double[] values = history.values(i);
                add(values[0], values);
            }
            boolean any = total > samplesRead || restarted;
            samplesRead = total;
            return any;
        }
    }

    /** All values of a column, the oldest first. */
    double[] column(int column) {
        return IntStream.range(0, size).mapToDouble(i -> value(column, i)).toArray();
    }

    void set(int column, int sample, double value) {
        columns[column][index(sample)] = value;
    }

    void clearColumn(int column) {
        Arrays.fill(columns[column], Double.NaN);
    }

    void clear() {
        first = 0;
        size = 0;
        samplesRead = 0;
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
     * Writes a column between two times, decimated to the length of {@code x}: where there are more samples than
     * points, each interval gives its least and its greatest value. NaN values are left out.
     *
     * @return points written
     */
    int curve(int column, double from, double to, double[] x, double[] y) {
        int begin = Math.max(0, firstFrom(from) - 1);
        int end = Math.min(size, firstFrom(to) + 1);
        int count = end - begin;
        int intervals = count <= x.length ? count : x.length / 2;
        int written = 0;
        for (int s = 0; s < intervals; s++) {
            int low = begin + (int) ((long) count * s / intervals);
            int high = begin + (int) ((long) count * (s + 1) / intervals);
            written += extremes(column, low, high, written, x, y);
        }
        return written;
    }

    /** Writes the least and the greatest value of an interval in their order in time; returns their number, 0 to 2. */
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
