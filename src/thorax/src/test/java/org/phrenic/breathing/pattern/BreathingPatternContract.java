package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;

import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;

/** What every pattern must hold, whatever it breathes. */
final class BreathingPatternContract {
    private static final double STEP_S = 1e-4;

    /** Second-order differences over 0.1 ms of curves with third derivatives of some 1e5 per s^3 at most. */
    private static final double DIFFERENCED = 2e-4;

    /**
     * Sniffs and coughs turn their rates round within 0.1 s: bounded second derivative, 1/s^2. A kink of 0.01 per s
     * would show as 100.
     */
    private static final double LARGEST_ACCELERATION = 100;

    /** Of both pressures, 1/s. */
    private static final double LARGEST_PRESSURE_RATE = 20;

    private BreathingPatternContract() {}

    static void check(BreathingPattern pattern, double durationS) {
        startsAtRest(pattern);
        isSmooth(pattern, durationS);
    }

    private static void startsAtRest(BreathingPattern pattern) {
        for (double before : new double[] {-1, 0}) {
            BreathState state = at(pattern, before);
            assertThat(state.activation).isZero();
            assertThat(state.activationRate).isZero();
            assertThat(state.ribTurn).isZero();
            assertThat(state.ribTurnRate).isZero();
            assertThat(state.pressure).isZero();
            assertThat(state.abdominalPressure).isZero();
            assertThat(state.breath).isZero();
        }
    }

    private static void isSmooth(BreathingPattern pattern, double durationS) {
        BreathState last = at(pattern, 0);
        BreathState here = new BreathState();
        int steps = (int) (durationS / STEP_S);
        for (int n = 1; n <= steps; n++) {
            double t = n * STEP_S;
            pattern.at(t, here);
            assertShare("activation", here.activation, t);
            assertShare("pressure", here.pressure, t);
            assertShare("abdominal pressure", here.abdominalPressure, t);
            assertShare("turn of the ribs", here.ribTurn, t);
            if (!(here.phase >= 0 && here.phase < 1)) {
                throw new AssertionError("phase " + here.phase + " at " + t + " s");
            }
            assertRate("activation", last.activation, last.activationRate, here.activation, here.activationRate, t);
            assertRate("turn", last.ribTurn, last.ribTurnRate, here.ribTurn, here.ribTurnRate, t);
            assertNoJump("pressure", last.pressure, here.pressure, t);
            assertNoJump("abdominal pressure", last.abdominalPressure, here.abdominalPressure, t);
            if (here.breath < last.breath || here.breath > last.breath + 1) {
                throw new AssertionError("breath " + here.breath + " after " + last.breath + " at " + t + " s");
            }
            BreathState spare = last;
            last = here;
            here = spare;
        }
    }

    private static void assertShare(String what, double value, double t) {
        if (!(value >= 0 && value <= 1)) {
            throw new AssertionError(what + " " + value + " at " + t + " s, expected 0 to 1");
        }
    }

    private static void assertNoJump(String what, double before, double after, double t) {
        if (Math.abs(after - before) > LARGEST_PRESSURE_RATE * STEP_S) {
            throw new AssertionError(what + " jumps at " + t + " s");
        }
    }

    private static void assertRate(String what, double v0, double r0, double v1, double r1, double t) {
        if (Math.abs(v1 - v0 - 0.5 * (r0 + r1) * STEP_S) > DIFFERENCED * STEP_S) {
            throw new AssertionError(what + " changes by " + (v1 - v0) / STEP_S + " per s at " + t + " s, its rate is "
                    + 0.5 * (r0 + r1));
        }
        if (Math.abs(r1 - r0) > LARGEST_ACCELERATION * STEP_S) {
            throw new AssertionError(what + " has a kink at " + t + " s: rate " + r0 + ", then " + r1);
        }
    }

    static BreathState at(BreathingPattern pattern, double timeS) {
        BreathState state = new BreathState();
        pattern.at(timeS, state);
        return state;
    }
}
