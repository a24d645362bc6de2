package org.phrenic.ui.chart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Observation;

/**
 * Respiratory phases of recorded samples, from the drives of diaphragm and ribs: rising in inspiration, falling in
 * expiration, constant in a pause (at rest) and a hold. A turn counts once the drives have gone back by
 * {@value #MIN_TURN_SHARE} of their range between the two times, so that noise in a recorded breath is no phase. For
 * the same reason a pause in an expiration, or an expiration in a pause, lasts {@value #MIN_INTERRUPTION_S} s or more.
 */
final class PhaseBands {
    /** An interval of one phase, s; {@code breath} counts the breaths before it. */
    record Band(double from, double to, RespiratoryPhase label, int breath) {}

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int ACTIVATION = Observation.COLUMNS.indexOf("activation");
    private static final int RIB_TURN = Observation.COLUMNS.indexOf("rib_turn");

    /**
     * Rate below which the drives are constant, 1/s: a hold drifts by 0.08 in 24 s, quiet breathing moves 0.27 in 1 s.
     */
    private static final double STATIONARY_RATE_PER_S = 0.02;

    /** Sum of the drives below which they are at rest. */
    private static final double REST_THRESHOLD = 0.01;

    /** Shortest hold, s; the turning point between phases is shorter. */
    private static final double MIN_HOLD_S = 0.3;

    private static final double MIN_TURN_SHARE = 0.08;

    private static final double MIN_INTERRUPTION_S = 0.4;

    private PhaseBands() {}

    /** Bands between two times, in order and without gaps; none where nothing is recorded. */
    static List<Band> of(SampleRingBuffer ring, double from, double to) {
        List<Band> bands = new ArrayList<>();
        int end = Math.min(ring.size(), ring.firstFrom(to) + 1);
        int begin = Math.max(1, ring.firstFrom(from));
        boolean[] rising = rising(ring, begin, end);
        for (int i = begin; i < end; i++) {
            RespiratoryPhase label = label(ring, i, rising[i - begin]);
            append(bands, new Band(ring.time(i - 1), ring.time(i), label, (int) ring.value(BREATH, i)), false);
        }
        List<Band> merged = new ArrayList<>();
        for (Band band : bands) {
            append(merged, band, band.label == RespiratoryPhase.HOLD && band.to - band.from < MIN_HOLD_S);
        }
        return withoutInterruptions(merged);
    }

    /** Joins bands of one phase and breath that a short pause, or a short movement in a pause, separates. */
    private static List<Band> withoutInterruptions(List<Band> bands) {
        List<Band> joined = new ArrayList<>();
        for (int i = 0; i < bands.size(); i++) {
            Band last = joined.isEmpty() ? null : joined.get(joined.size() - 1);
            Band band = bands.get(i);
            boolean within = last != null
                    && i + 1 < bands.size()
                    && bands.get(i + 1).label == last.label
                    && bands.get(i + 1).breath == last.breath;
            boolean still = within && (isStill(last.label) || isStill(band.label));
            append(joined, band, still && band.to - band.from < MIN_INTERRUPTION_S);
        }
        return joined;
    }

    private static boolean isStill(RespiratoryPhase phase) {
        return phase == RespiratoryPhase.PAUSE || phase == RespiratoryPhase.HOLD;
    }

    /**
     * Appends a band, merged into the last one if they are of one phase and breath, or in any case if {@code merge}.
     */
    private static void append(List<Band> bands, Band band, boolean merge) {
        Band last = bands.isEmpty() ? null : bands.get(bands.size() - 1);
        if (last != null && (merge || (last.label == band.label && last.breath == band.breath))) {
            bands.set(bands.size() - 1, new Band(last.from, band.to, last.label, last.breath));
        } else {
            bands.add(band);
        }
    }

    /** Whether the drives rise towards each of these samples, between turning points that are no noise. */
    private static boolean[] rising(SampleRingBuffer ring, int begin, int end) {
        boolean[] rising = new boolean[Math.max(0, end - begin)];
        if (rising.length == 0) {
            return rising;
        }
        double[] sums = IntStream.range(begin - 1, end)
                .mapToDouble(i -> driveSum(ring, i))
                .toArray();
        DoubleSummaryStatistics range = Arrays.stream(sums).summaryStatistics();
        double turn = MIN_TURN_SHARE * (range.getMax() - range.getMin());
        int extreme = 0;
        int least = 0;
        int greatest = 0;
        int direction = 0;
        for (int i = 1; i < sums.length; i++) {
            least = sums[i] <= sums[least] ? i : least;
            greatest = sums[i] >= sums[greatest] ? i : greatest;
            boolean turnsUp = direction <= 0 && sums[i] - sums[least] > turn;
            boolean turnsDown = direction >= 0 && sums[greatest] - sums[i] > turn;
            if (turnsUp || turnsDown) {
                int turned = turnsUp ? least : greatest;
                Arrays.fill(rising, extreme, turned, direction == 0 ? turnsDown : direction > 0);
                direction = turnsUp ? 1 : -1;
                extreme = turned;
                least = i;
                greatest = i;
            }
        }
        Arrays.fill(rising, extreme, rising.length, direction == 0 ? sums[sums.length - 1] > sums[0] : direction > 0);
        return rising;
    }

    private static RespiratoryPhase label(SampleRingBuffer ring, int i, boolean rising) {
        double now = driveSum(ring, i);
        double rate = (now - driveSum(ring, i - 1)) / (ring.time(i) - ring.time(i - 1));
        if (Math.abs(rate) < STATIONARY_RATE_PER_S) {
            return now < REST_THRESHOLD ? RespiratoryPhase.PAUSE : RespiratoryPhase.HOLD;
        }
        return rising ? RespiratoryPhase.INSPIRATION : RespiratoryPhase.EXPIRATION;
    }

    private static double driveSum(SampleRingBuffer ring, int i) {
        return ring.value(ACTIVATION, i) + ring.value(RIB_TURN, i);
    }
}
