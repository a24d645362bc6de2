package org.phrenic.study.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.study.BreathSeries;

/**
 * Curves with known answers: x falls by 20 from 100 while y grows by 500, both on straight lines; on the way back x
 * lags 4 behind. z falls by 5 from 40.
 */
final class SyntheticBreath {
    static final List<String> COLUMNS = List.of("breath", "dome_right_mm", "dome_left_mm", "x", "y", "z");
    private static final int STEPS = 20;

    private SyntheticBreath() {}

    /** In, out, and the first sample of the next breath. */
    static BreathSeries breath() {
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            double s = (double) i / STEPS;
            rows.add(new double[] {0, -10 * s, -12 * s, 100 - 20 * s, 500 * s, 40 - 5 * s});
        }
        for (int i = 1; i < STEPS; i++) {
            double s = 1 - (double) i / STEPS;
            rows.add(new double[] {0, -10 * s, -12 * s, 96 - 20 * s, 500 * s, 40 - 5 * s});
        }
        rows.add(new double[] {1, 0, 0, 100, 0, 40});
        return new BreathSeries(COLUMNS, rows, Collections.nCopies(rows.size(), RespiratoryPhase.INSPIRATION));
    }

    /** A breath before, then one that is held while x creeps up by 3 and y falls by 50. */
    static BreathSeries hold() {
        List<double[]> rows = List.of(
                new double[] {0, 0, 0, 90, 0, 0},
                new double[] {0, -1, -1, 80, 100, 0},
                new double[] {1, 0, 0, 100, 0, 0},
                new double[] {1, -30, -30, 40, 2000, 0},
                new double[] {1, -29, -29, 43, 1950, 0},
                new double[] {1, 0, 0, 100, 0, 0});
        List<RespiratoryPhase> labels = List.of(
                RespiratoryPhase.INSPIRATION,
                RespiratoryPhase.EXPIRATION,
                RespiratoryPhase.INSPIRATION,
                RespiratoryPhase.HOLD,
                RespiratoryPhase.HOLD,
                RespiratoryPhase.EXPIRATION);
        return new BreathSeries(COLUMNS, rows, labels);
    }
}
