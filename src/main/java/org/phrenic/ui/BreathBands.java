package org.phrenic.ui;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Observation;

/** What the breath did over recorded times, read off the drives: both rise in inspiration and fall in expiration; where they stand still it is a pause at rest and a hold elsewhere. */
final class BreathBands {
    /**
     * A stretch of time.
     *
     * @param from s
     * @param to s
     * @param label what the breath did
     * @param breath breaths begun before it
     */
    record Band(double from, double to, BreathLabel label, int breath) {}

    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int ACTIVATION = Observation.COLUMNS.indexOf("activation");
    private static final int RIB_TURN = Observation.COLUMNS.indexOf("rib_turn");

    /** Slower than this the drives stand still, 1/s: a held breath creeps by 0.08 in 24 s, a quiet one moves by 0.27 in a second. */
    private static final double STILL_PER_S = 0.02;

    /** Below this they are at rest. */
    private static final double AT_REST = 0.01;

    /** The turn at the end of a breath is no hold, s. */
    private static final double SHORTEST_HOLD_S = 0.3;

    private BreathBands() {}

    /** Bands between two times, in order and without gaps; none where nothing was recorded. */
    static List<Band> of(SampleRing ring, double from, double to) {
        List<Band> bands = new ArrayList<>();
        int end = Math.min(ring.size(), ring.firstFrom(to) + 1);
        for (int i = Math.max(1, ring.firstFrom(from)); i < end; i++) {
            BreathLabel label = label(ring, i);
            int breath = (int) ring.value(BREATH, i);
            Band last = bands.isEmpty() ? null : bands.get(bands.size() - 1);
            if (last != null && last.label == label && last.breath == breath) {
                bands.set(bands.size() - 1, new Band(last.from, ring.time(i), label, breath));
            } else {
                bands.add(new Band(ring.time(i - 1), ring.time(i), label, breath));
            }
        }
        return withoutTurns(bands);
    }

    private static BreathLabel label(SampleRing ring, int i) {
        double now = drive(ring, i);
        double rate = (now - drive(ring, i - 1)) / (ring.time(i) - ring.time(i - 1));
        if (Math.abs(rate) < STILL_PER_S) {
            return now < AT_REST ? BreathLabel.PAUSE : BreathLabel.HOLD;
        }
        return rate > 0 ? BreathLabel.INSPIRATION : BreathLabel.EXPIRATION;
    }

    private static double drive(SampleRing ring, int i) {
        return ring.value(ACTIVATION, i) + ring.value(RIB_TURN, i);
    }

    private static List<Band> withoutTurns(List<Band> bands) {
        List<Band> kept = new ArrayList<>();
        for (Band band : bands) {
            boolean turn = band.label == BreathLabel.HOLD && band.to - band.from < SHORTEST_HOLD_S;
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
