package org.phrenic.ui.chart;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.simulation.observe.Observation;

/**
 * One whole breath of a run: every observable as a function of the phase of the breath, 0 to 1.
 *
 * @param name settings that it was breathed with
 * @param phase phases of the samples, ascending
 * @param columns samples of each of {@link Observation#COLUMNS}
 */
@SuppressWarnings("ArrayRecordComponent") // samples, read only
record KeptBreath(String name, double[] phase, double[][] columns) {
    static final int PHASE = Observation.COLUMNS.indexOf("phase");
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    /** The last whole breath that began at or after a time, s; empty if there is none. */
    static Optional<KeptBreath> last(String name, SampleRingBuffer ring, double fromS) {
        int end = onset(ring, ring.size() - 1);
        int begin = onset(ring, end - 1);
        if (end < 0 || begin < 0 || ring.time(begin) < fromS) {
            return Optional.empty();
        }
        double[] phase = samples(ring, PHASE, begin, end);
        phase[phase.length - 1] = 1;
        double[][] columns = IntStream.range(0, Observation.COLUMNS.size())
                .mapToObj(column -> samples(ring, column, begin, end))
                .toArray(double[][]::new);
        return Optional.of(new KeptBreath(name, phase, columns));
    }

    /** First sample of a breath at or before a sample; -1 if its breath began before the record. */
    private static int onset(SampleRingBuffer ring, int sample) {
        for (int i = sample; i > 0; i--) {
            if (ring.value(BREATH, i) != ring.value(BREATH, i - 1)) {
                return i;
            }
        }
        return sample >= 0 && ring.time(0) == 0 ? 0 : -1;
    }

    private static double[] samples(SampleRingBuffer ring, int column, int begin, int end) {
        return IntStream.rangeClosed(begin, end)
                .mapToDouble(i -> ring.value(column, i))
                .toArray();
    }

    /** Value of an observable at a phase, linear between samples; NaN for a column that is none. */
    double value(int column, double at) {
        if (column >= columns.length) {
            return Double.NaN;
        }
        int found = Arrays.binarySearch(phase, at);
        int after = found >= 0 ? found : -found - 1;
        if (found >= 0 || after == 0 || after == phase.length) {
            return columns[column][Math.min(after, phase.length - 1)];
        }
        double share = (at - phase[after - 1]) / (phase[after] - phase[after - 1]);
        return columns[column][after - 1] + share * (columns[column][after] - columns[column][after - 1]);
    }

    /** Greatest less least value of an observable; NaN for a column that is none. */
    double peakToPeak(int column) {
        if (column >= columns.length) {
            return Double.NaN;
        }
        return Arrays.stream(columns[column]).max().orElseThrow()
                - Arrays.stream(columns[column]).min().orElseThrow();
    }
}
