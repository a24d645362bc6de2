package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.phrenic.breathing.pattern.BreathingPatternContract.at;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.Ramp;

class BlendedPatternTest {
    private final BreathingPreset quiet = preset("quiet");

    @Test
    void aChangeIsSmoothAndCountsOn() {
        BreathingPattern pattern =
                BlendedPattern.change(quiet.pattern(), preset("deep").pattern(), 5.5, 0.5);
        BreathingPatternContract.check(pattern, 20);
        assertThat(at(pattern, 5).activation).isEqualTo(at(quiet.pattern(), 5).activation);
        // the deep breath began at 5.5 s and is full 3.6 s later
        assertThat(at(pattern, 9.1).activation).isCloseTo(1, within(1e-12));
        assertThat(at(pattern, 9.1).breath).isEqualTo(2);
    }

    @Test
    void aChangeOfRateGoesOnWhereTheBreathIs() {
        BreathingPattern faster = quiet.pattern(quiet.parameters().withRatePerMin(30));
        BreathingPattern pattern = BlendedPattern.changeInPhase(quiet.pattern(), faster, 5, Ramp.DEFAULT_S);
        BreathingPatternContract.check(pattern, 20);
        // a quarter into the breath, with both rates
        assertThat(at(pattern, 5).phase).isCloseTo(0.25, within(1e-12));
        assertThat(at(pattern, 5).activation).isCloseTo(at(quiet.pattern(), 5).activation, within(1e-12));
        assertThat(at(pattern, 5 + 2).phase).isCloseTo(0.25, within(1e-12));
        assertThatThrownBy(() -> BlendedPattern.changeInPhase(
                        quiet.pattern(), preset("hold-expiration").pattern(), 5, 0.2))
                .hasMessage(
                        "breathing: 'hold-expiration' does not repeat itself, expected a pattern to go on with in phase");
    }

    /** A slider dragged for a second at 50 changes a second. */
    @Test
    void manyChangesInARowStaySmooth() {
        BreathingPattern pattern = quiet.pattern();
        for (int n = 0; n < 50; n++) {
            BreathingPattern deeper = quiet.pattern(quiet.parameters().withDepth(1 + 0.02 * n));
            pattern = BlendedPattern.changeInPhase(pattern, deeper, 3 + 0.02 * n, Ramp.DEFAULT_S);
        }
        BreathState last = at(pattern, 2.5);
        for (double t = 2.5001; t < 8; t += 1e-4) {
            BreathState here = at(pattern, t);
            assertThat(Math.abs(here.activation - last.activation)).isLessThan(1e-4);
            last = here;
        }
        assertThat(at(pattern, 4 + 1.6).activation).isCloseTo(1.98 * 0.26, within(1e-9));
    }

    private static BreathingPreset preset(String name) {
        try {
            return BreathingPreset.named(name);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
