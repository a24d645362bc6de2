package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.phrenic.breathing.pattern.BreathingPatternContract.at;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.RespiratoryPhase;

class BreathingPatternsTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    private static final BreathingParameters QUIET = new BreathingParameters(15, 0.40, 0.10, 0.26, 0.06, 1.0 / 6, 0.5);
    private static final BreathingParameters FULL = new BreathingParameters(7.5, 0.45, 0.05, 1, 0.25, 1, 0.5);

    @Test
    void breathsRepeatExactlyAndRestInThePause() {
        BreathingPattern quiet = new PeriodicPattern(QUIET);
        for (int n = 0; n < 64; n++) {
            // 1/16 s are exact in binary, as is the period: the same bits must come back
            double t = n / 16.0;
            assertThat(at(quiet, t + 40).activation).isEqualTo(at(quiet, t).activation);
            assertThat(at(quiet, t + 40).ribTurnRate).isEqualTo(at(quiet, t).ribTurnRate);
            assertThat(at(quiet, t + 40).breath).isEqualTo(10);
        }
        for (double t = 3.6001; t < 4; t += 0.01) {
            assertThat(at(quiet, t).activation).isZero();
            assertThat(at(quiet, t).ribTurn).isZero();
            assertThat(at(quiet, t).ribTurnRate).isZero();
            assertThat(at(quiet, t).respiratoryPhase).isEqualTo(RespiratoryPhase.PAUSE);
        }
        assertThat(at(quiet, 1).respiratoryPhase).isEqualTo(RespiratoryPhase.INSPIRATION);
        assertThat(at(quiet, 2).respiratoryPhase).isEqualTo(RespiratoryPhase.EXPIRATION);
    }

    /** Passive expiration: half emptied well before half of its time. */
    @Test
    void expirationIsFastFirst() {
        BreathingPattern quiet = new PeriodicPattern(QUIET);
        assertThat(at(quiet, 1.6 + 1).activation).isLessThan(0.3 * 0.26);
    }

    /** Beyer et al. 2016: above the middle of the capacity ribs move much less than below it. */
    @Test
    void deepBreathsTurnTheRibsEarlyAndTheMuscleGoesWithThem() {
        BreathingPattern deep = new PeriodicPattern(FULL);
        BreathState middle = at(deep, 1.8);
        assertThat(middle.ribTurn).isCloseTo(0.731, within(1e-3));
        // muscle and pressure go with them, for the dome follows the volume (Houston et al. 1994)
        assertThat(middle.activation).isCloseTo(middle.ribTurn, ROUNDING);
        assertThat(middle.pressure).isCloseTo(0.25 * middle.ribTurn, ROUNDING);
    }

    /** PMC7055431: 5.6 mm of a full excursion of 70 mm in 24 s, that is 0.08 of the drive. */
    @Test
    void heldInspirationCreepsByTheStatedShare() {
        double creep = 5.6 / 70;
        HoldPattern hold = new HoldPattern(QUIET, 2, FULL, 30, creep);
        double start = 2 * 4 + 0.45 * 8;
        BreathState beginning = at(hold, start);
        assertThat(beginning.activation).isCloseTo(1, ROUNDING);
        BreathState after = at(hold, start + HoldPattern.CREEP_TIME_S);
        assertThat(after.respiratoryPhase).isEqualTo(RespiratoryPhase.HOLD);
        assertThat(after.activation).isCloseTo(1 - creep, ROUNDING);
        assertThat(after.pressure).isCloseTo(0.25 * (1 - creep), ROUNDING);
        assertThat(after.ribTurn).isCloseTo(1, ROUNDING);
        assertThat(after.ribTurnRate).isZero();
        assertThat(after.breath).isEqualTo(2);
        // 7.6 s of breath and 30 s of hold later all is at rest, then the third quiet breath goes on
        assertThat(at(hold, start + 30 + 4).activation).isZero();
        assertThat(at(hold, 8 + 38 + 1.6).activation).isCloseTo(0.26, ROUNDING);
        assertThat(at(hold, 8 + 38 + 1.6).breath).isEqualTo(3);
        BreathingPatternContract.check(hold, 60);
    }

    @Test
    void heldExpirationRests() {
        HoldPattern hold = new HoldPattern(QUIET, 1, null, 10, 0);
        for (double t = 4; t < 14; t += 0.1) {
            BreathState state = at(hold, t);
            assertThat(state.activation).isZero();
            assertThat(state.ribTurn).isZero();
            assertThat(state.respiratoryPhase).isEqualTo(RespiratoryPhase.HOLD);
        }
        assertThat(at(hold, 15.6).activation).isCloseTo(0.26, ROUNDING);
        BreathingPatternContract.check(hold, 20);
    }

    /**
     * 0.9 s in, 0.2 s against the glottis, 0.4 s out: pressure outlasts the drive, so that it can push the domes up.
     */
    @Test
    void coughPressesAfterTheDiaphragmGaveWay() {
        BreathingParameters cough = new BreathingParameters(10, 0.15, 0, 0.5, 0.12, 0.33, 0.5);
        CoughPattern pattern = new CoughPattern(cough, 0.2, 0.4, 0.75);
        assertThat(at(pattern, 0.9).activation).isCloseTo(0.5, ROUNDING);
        assertThat(at(pattern, 1.0).respiratoryPhase).isEqualTo(RespiratoryPhase.HOLD);
        assertThat(at(pattern, 1.1).abdominalPressure).isCloseTo(0.75, ROUNDING);
        BreathState expulsion = at(pattern, 1.3);
        assertThat(expulsion.respiratoryPhase).isEqualTo(RespiratoryPhase.EXPIRATION);
        assertThat(expulsion.activation).isCloseTo(0, ROUNDING);
        assertThat(expulsion.abdominalPressure).isCloseTo(0.75, ROUNDING);
        BreathState rest = at(pattern, 1.95);
        assertThat(rest.activation).isZero();
        assertThat(rest.abdominalPressure).isZero();
        assertThat(rest.ribTurn).isZero();
        BreathingPatternContract.check(pattern, 12);
        assertThatThrownBy(() -> new CoughPattern(cough.withRatePerMin(60), 0.2, 0.4, 0.75))
                .hasMessageContaining("within the period of 1.0 s");
    }

    @Test
    void waxingBreathsWaxWaneAndStop() {
        BreathingParameters deepest = new BreathingParameters(24, 0.42, 0.05, 0.5, 0.12, 0.33, 0.5);
        CheyneStokesPattern pattern = new CheyneStokesPattern(deepest, 16, 20);
        assertThat(pattern.periodS()).isEqualTo(60);
        double[] peaks = new double[16];
        for (int k = 0; k < 16; k++) {
            peaks[k] = at(pattern, (k + 0.42) * 2.5).activation;
        }
        for (int k = 1; k < 8; k++) {
            assertThat(peaks[k]).isGreaterThan(peaks[k - 1]);
            assertThat(peaks[15 - k]).isGreaterThan(peaks[16 - k]);
        }
        assertThat(peaks[7]).isBetween(0.48, 0.5);
        for (double t = 40; t < 60; t += 0.5) {
            assertThat(at(pattern, t).activation).isZero();
        }
        assertThat(at(pattern, 61).breath).isEqualTo(16);
        BreathingPatternContract.check(pattern, 65);
    }

    @Test
    void rampsArriveSmoothly() {
        Ramp ramp = Ramp.of(2, 5, 10);
        assertThat(ramp.at(9)).isEqualTo(2);
        assertThat(ramp.at(10.1)).isCloseTo(3.5, ROUNDING);
        assertThat(ramp.at(10.2 + 1e-9)).isEqualTo(5);
        assertThat(ramp.isDone(10.19)).isFalse();
        assertThat(ramp.isDone(10.21)).isTrue();
        double h = 1e-6;
        assertThat(ramp.rate(10.07)).isCloseTo((ramp.at(10.07 + h) - ramp.at(10.07 - h)) / (2 * h), within(1e-6));
        assertThat(ramp.rate(10)).isZero();
        assertThatThrownBy(() -> new Ramp(0, 1, 0, 0)).hasMessage("ramp: duration 0.0 s, expected more than 0");
    }

    @Test
    void badHoldsAndCyclesAreRefused() {
        assertThatThrownBy(() -> new HoldPattern(QUIET, 1, FULL, 0, 0.1))
                .hasMessage(
                        "breath hold: breaths_before 1 and hold_s 0.0, expected at least 0 breaths and more than 0 s");
        assertThatThrownBy(() -> new HoldPattern(QUIET, 1, FULL, 5, 1))
                .hasMessage("breath hold: creep_fraction 1.0, expected from 0 to below 1");
        assertThatThrownBy(() -> new CheyneStokesPattern(QUIET, 0, 20))
                .hasMessage(
                        "waxing and waning: breaths 0 and apnoea_s 20.0, expected at least 1 breath and at least 0 s");
    }
}
