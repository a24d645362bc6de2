package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The record of a known curve: its values and velocities, its end, and the period that it keeps. */
class RecordedBreathTest {
    private static final double PERIOD_S = 1.03;
    private static final double INTERVAL_S = 0.02;
    private static final double FIRST_S = 5.5;

    /** A period of a cosine of 10 mm, and a drift. */
    private static double curve(double timeS, double driftMmPerS) {
        return 10 * Math.cos(2 * Math.PI * timeS / PERIOD_S) + driftMmPerS * timeS;
    }

    private static RecordedBreath record(int samples, double driftMmPerS) {
        RecordedBreath record = new RecordedBreath(FIRST_S, PERIOD_S, INTERVAL_S);
        for (int k = 0; k < samples; k++) {
            record.add(new double[] {curve(FIRST_S + k * INTERVAL_S, driftMmPerS)});
        }
        return record;
    }

    private static double[] at(RecordedBreath record, double timeS) {
        double[] x = new double[1];
        double[] v = new double[1];
        record.at(timeS, x, v);
        return new double[] {x[0], v[0]};
    }

    @Test
    void repeatsACurveInEveryLaterPeriod() {
        RecordedBreath record = record(80, 0);
        assertThat(record.close(0.01)).isTrue();
        for (double t = 9; t < 12; t += 0.0137) {
            double[] state = at(record, t);
            // The cubic's error for a cosine: amplitude (omega h)^3 / 8 at most for the slope of differences, 0.02 mm.
            assertThat(state[0]).as("at %s", t).isCloseTo(curve(t, 0), within(0.005));
            double omega = 2 * Math.PI / PERIOD_S;
            assertThat(state[1]).as("velocity at %s", t).isCloseTo(-10 * omega * Math.sin(omega * t), within(0.5));
        }
    }

    @Test
    void isNotClosedBeforeItCoversThePeriodNorWhereItsEndsDiffer() {
        assertThat(record(54, 0).close(0.01))
                .as("1.06 s less an interval at either end")
                .isFalse();
        assertThat(record(55, 0).close(0.01)).isTrue();
        assertThat(record(70, 0.1).close(0.1))
                .as("a drift of 0.103 mm a period")
                .isFalse();
        assertThat(record(70, 0.1).close(0.11)).isTrue();
    }

    @Test
    void beginsAndEndsAtTheEndThatWasReached() {
        RecordedBreath record = record(70, 0.1);
        assertThat(record.close(0.2)).isTrue();
        // The last period covered: the second sample of the window begins it, an interval before the last ends it.
        double end = FIRST_S + 67 * INTERVAL_S;
        double start = FIRST_S + (70 - 55 + 1) * INTERVAL_S;
        assertThat(start + PERIOD_S).isBetween(end - INTERVAL_S, end + INTERVAL_S);
        double reached = curve(start + PERIOD_S, 0.1);
        assertThat(at(record, start)[0]).isCloseTo(reached, within(0.005));
        assertThat(at(record, start + PERIOD_S - 1e-9)[0]).isCloseTo(reached, within(0.005));
        assertThat(at(record, start + 3 * PERIOD_S)[0]).isCloseTo(reached, within(0.005));
    }

    /** The end is 2.06 mm above the beginning; what closes the record takes 2 mm/s from its velocity. */
    @Test
    void isWithoutItsDriftThroughoutThePeriod() {
        double drift = 2;
        RecordedBreath record = record(70, drift);
        assertThat(record.close(3)).isTrue();
        double start = FIRST_S + (70 - 55 + 1) * INTERVAL_S;
        double omega = 2 * Math.PI / PERIOD_S;
        for (double t = start; t < start + PERIOD_S; t += 0.0137) {
            double[] state = at(record, t);
            assertThat(state[0]).as("at %s", t).isCloseTo(curve(t, 0) + drift * (start + PERIOD_S), within(0.005));
            assertThat(state[1]).as("velocity at %s", t).isCloseTo(-10 * omega * Math.sin(omega * t), within(0.5));
        }
    }
}
