package org.phrenic.ui.chart;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Observation;

/**
 * What the breath did over recorded times, read off the drives: both rise in inspiration and fall in expiration; where
 * they stand still it is a pause at rest and a hold elsewhere.
 */
final class PhaseBands {
    /**
     * A stretch of time.
     *
     * @param from s
     * @param to s
     * @param label what the breath did
     * @param breath breaths begun before it
     */
    record Band(double from, double to, RespiratoryPhase label, int breath) {}

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int ACTIVATION = Observation.COLUMNS.indexOf("activation");
    private static final int RIB_TURN = Observation.COLUMNS.indexOf("rib_turn");

    /**
     * Slower than this the drives stand still, 1/s: a held breath creeps by 0.08 in 24 s, a quiet one moves by 0.27 in
     * a second.
     */
    private static final double STATIONARY_RATE_PER_S = 0.02;

    /** Below this they are at rest. */
    private static final double REST_THRESHOLD = 0.01;

    /** The turn at the end of a breath is no hold, s. */
    private static final double MIN_HOLD_S = 0.3;

    private PhaseBands() {}

    /** Bands between two times, in order and without gaps; none where nothing was recorded. */
    static List<Band> of(SampleRingBuffer ring, double from, double to) {
        List<Band> bands = new ArrayList<>();
        int end = Math.min(ring.size(), ring.firstFrom(to) + 1);
        for (int i = Math.max(1, ring.firstFrom(from)); i < end; i++) {
            RespiratoryPhase label = label(ring, i);
            int breath = (int) ring.value(BREATH, i);
            Band last = bands.isEmpty() ? null : bands.get(bands.size() - 1);
            if (last != null && last.label == label && last.breath == breath) {
                bands.set(bands.size() - 1, new Band(last.from, ring.time(i), label, breath));
            } else {
                bands.add(new Band(ring.time(i - 1), ring.time(i), label, breath));
            }
        }
        return mergeTurningPoints(bands);
    }

    private static RespiratoryPhase label(SampleRingBuffer ring, int i) {
        double now = driveSum(ring, i);
        double rate = (now - driveSum(ring, i - 1)) / (ring.time(i) - ring.time(i - 1));
        if (Math.abs(rate) < STATIONARY_RATE_PER_S) {
            return now < REST_THRESHOLD ? RespiratoryPhase.PAUSE : RespiratoryPhase.HOLD;
        }
        return rate > 0 ? RespiratoryPhase.INSPIRATION : RespiratoryPhase.EXPIRATION;
    }

    private static double driveSum(SampleRingBuffer ring, int i) {
        return ring.value(ACTIVATION, i) + ring.value(RIB_TURN, i);
    }

    private static List<Band> mergeTurningPoints(List<Band> bands) {
        List<Band> kept = new ArrayList<>();
        for (Band band : bands) {
            boolean turn = band.label == RespiratoryPhase.HOLD && band.to - band.from < MIN_HOLD_S;
            Band last = kept.isEmpty() ? null : kept.get(kept.size() - 1);
            if (last != null && (turn || (last.label == band.label && last.breath == band.breath))) {
                kept.set(kept.size() - 1, new Band(last.from, band.to, last.label, last.breath));
            } else {
                kept.add(band);
            }
        }
        return kept;
    }
}
