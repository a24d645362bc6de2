package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.phrenic.breathing.pattern.BreathingPatternContract.at;

import org.junit.jupiter.api.Test;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;
import org.phrenic.breathing.TimeWarp;

class BlendedPatternTest {
    private final BreathingPreset quiet = preset("quiet");

    @Test
    void aChangeIsSmoothAndCountsOn() {
        BreathingPattern pattern =
                BlendedPattern.crossfade(quiet.pattern(), shifted(preset("deep").pattern(), 5.5), 5.5, 0.5, true);
        BreathingPatternContract.check(pattern, 20);
        assertThat(at(pattern, 5).activation).isEqualTo(at(quiet.pattern(), 5).activation);
        // the deep breath began at 5.5 s and is full 3.6 s later
        assertThat(at(pattern, 9.1).activation).isCloseTo(1, within(1e-12));
        assertThat(at(pattern, 9.1).breath).isEqualTo(2);
    }

    @Test
    void halfwayThroughAChangePressuresAreTheMeansOfBoth() {
        BreathingPattern cough = preset("cough").pattern();
        double half = 0.25;
        for (double nowS = 0.5; nowS < 1.4; nowS += 0.1) {
            BreathState breathing = at(quiet.pattern(), nowS + half);
            BreathState coughing = at(cough, nowS + half);
            BreathState coming =
                    at(BlendedPattern.crossfade(quiet.pattern(), cough, nowS, 2 * half, false), nowS + half);
            BreathState going =
                    at(BlendedPattern.crossfade(cough, quiet.pattern(), nowS, 2 * half, false), nowS + half);
            for (BreathState blended : new BreathState[] {coming, going}) {
                assertThat(blended.pressure).isCloseTo((breathing.pressure + coughing.pressure) / 2, within(1e-12));
                assertThat(blended.abdominalPressure)
                        .isCloseTo((breathing.abdominalPressure + coughing.abdominalPressure) / 2, within(1e-12));
            }
        }
        // The cough's muscles press at 1.2 s, when those of a quiet breath rest.
        assertThat(at(cough, 1.2).abdominalPressure).isPositive();
        assertThat(at(quiet.pattern(), 1.2).pressure).isNotEqualTo(at(cough, 1.2).pressure);
    }

    @Test
    void aChangeOfRateGoesOnWhereTheBreathIs() {
        BreathingPattern faster = quiet.pattern(quiet.parameters().withRatePerMin(30));
        BreathingPattern pattern = inPhase(quiet.pattern(), faster, 5);
        BreathingPatternContract.check(pattern, 20);
        // a quarter into the breath, with both rates
        assertThat(at(pattern, 5).phase).isCloseTo(0.25, within(1e-12));
        assertThat(at(pattern, 5).activation).isCloseTo(at(quiet.pattern(), 5).activation, within(1e-12));
        assertThat(at(pattern, 5 + 2).phase).isCloseTo(0.25, within(1e-12));
    }

    /** A slider dragged for a second at 50 changes a second. */
    @Test
    void manyChangesInARowStaySmooth() {
        BreathingPattern pattern = quiet.pattern();
        for (int n = 0; n < 50; n++) {
            BreathingPattern deeper = quiet.pattern(quiet.parameters().withDepth(1 + 0.02 * n));
            pattern = inPhase(pattern, deeper, 3 + 0.02 * n);
        }
        BreathState last = at(pattern, 2.5);
        for (double t = 2.5001; t < 8; t += 1e-4) {
            BreathState here = at(pattern, t);
            assertThat(Math.abs(here.activation - last.activation)).isLessThan(1e-4);
            last = here;
        }
        assertThat(at(pattern, 4 + 1.6).activation).isCloseTo(1.98 * 0.26, within(1e-9));
    }

    /** The other pattern at the place in the breath where the first one is. */
    private static BreathingPattern inPhase(BreathingPattern from, BreathingPattern to, double nowS) {
        double originS = nowS - at(from, nowS).phase * to.periodS();
        return BlendedPattern.crossfade(from, shifted(to, originS), nowS, Ramp.DEFAULT_S, false);
    }

    private static BreathingPattern shifted(BreathingPattern pattern, double startS) {
        return new TimeWarpedPattern(pattern, new TimeWarp(true), startS);
    }

    private static BreathingPreset preset(String name) {
        return BreathingPreset.named(name);
    }
}
