package org.phrenic.breathing.pattern;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

class BreathingPresetTest {
    private static final String QUIET =
            """
            name: q
            kind: periodic
            rate_per_min: 15
            inspiratory_fraction: 0.4
            pause_fraction: 0.1
            activation: 0.26
            pressure: 0.06
            rib_turn: 0.1667
            chest_share: 0.5
            """;

    static List<String> names() {
        return BreathingPreset.names();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyPresetIsSmoothAndWithinItsRange(String name) {
        assertThat(BreathingPreset.named(name).name()).isEqualTo(name);
        BreathingPattern pattern = BreathingPreset.named(name).pattern();
        BreathingPatternContract.check(pattern, Math.min(2.1 * pattern.periodS(), 65));
    }

    @ParameterizedTest
    @MethodSource("names")
    void noPresetAllocatesInAStep(String name) {
        BreathingPattern pattern = BreathingPreset.named(name).pattern();
        BreathState state = new BreathState();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int n = 0; n < 10_000; n++) {
            pattern.at(0.01 * n, state);
        }
        // one object a step would be 160 kB at least
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(20_000);
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyPresetComesBackToExactRest(String name) {
        BreathingPattern pattern = BreathingPreset.named(name).pattern();
        double period = pattern.periodS();
        if (Double.isInfinite(period)) {
            return;
        }
        for (int n = 0; n < 50; n++) {
            // whole periods in binary: n * period has no rounding of its own for these
            BreathState state = BreathingPatternContract.at(pattern, n * period);
            assertThat(state.activation).as("%s after %d periods", name, n).isCloseTo(0, within(1e-15));
            assertThat(state.ribTurn).isCloseTo(0, within(1e-15));
        }
    }

    /** T = 4 s, Ti = 1.6 s, 1/6 of the ribs' full turn (physiology of VT 0.5 l of an IC of 3 l). */
    @Test
    void quietBreathIsOneSixthOfTheFullTurnAndDeepSevenTenths() {
        BreathingPattern quiet = BreathingPreset.named("quiet").pattern();
        assertThat(quiet.periodS()).isEqualTo(4);
        assertThat(BreathingPatternContract.at(quiet, 1.6).ribTurn).isCloseTo(1.0 / 6, within(1e-4));
        assertThat(BreathingPatternContract.at(quiet, 1.6).activation).isCloseTo(0.26, within(1e-12));
        BreathingPattern supine = BreathingPreset.named("quiet-supine").pattern();
        assertThat(BreathingPatternContract.at(supine, 1.6).ribTurn).isCloseTo(1.0 / 12, within(1e-4));
        BreathingPattern deep = BreathingPreset.named("deep").pattern();
        assertThat(deep.periodS()).isEqualTo(8);
        // The full turn belongs to full inspiration (Wilson et al. 1987); a deep breath stops short of it.
        assertThat(BreathingPatternContract.at(deep, 3.6).ribTurn).isCloseTo(0.7, within(1e-12));
    }

    @Test
    void cheyneStokesCyclesLastFrom45To90Seconds() {
        assertThat(BreathingPreset.named("cheyne-stokes").pattern().periodS()).isBetween(45.0, 90.0);
    }

    @Test
    void changedParametersMakeAnotherPatternOfTheSameKind() {
        BreathingPreset preset = BreathingPreset.named("quiet");
        BreathingParameters chest =
                preset.parameters().withRatePerMin(30).withDepth(2).withChestShare(0.75);
        BreathingPattern pattern = preset.pattern(chest);
        assertThat(pattern.periodS()).isEqualTo(2);
        // Ti 0.8 s; twice the depth, half of it taken from the diaphragm, half as much again for the ribs
        assertThat(BreathingPatternContract.at(pattern, 0.8).activation).isCloseTo(0.26, within(1e-12));
        assertThat(BreathingPatternContract.at(pattern, 0.8).ribTurn).isCloseTo(0.5, within(1e-3));
    }

    @Test
    void theDepthOfACoughIsAlsoThatOfItsAbdominalPressure() {
        BreathingPreset cough = BreathingPreset.named("cough");
        double[] depths = {0, 0.4, 1, 2};
        double[] peaks = {0, 0.3, 0.75, 1};
        for (int i = 0; i < depths.length; i++) {
            // The inspiration takes 0.9 s and the compression 0.2 s; then the pressure is held for 0.2 s.
            BreathingPattern pattern = cough.pattern(cough.parameters(), depths[i]);
            assertThat(BreathingPatternContract.at(pattern, 1.2).abdominalPressure)
                    .as("depth %s", depths[i])
                    .isCloseTo(peaks[i], within(1e-12));
        }
    }

    /** Two quiet breaths of 4 s stand before the held one of 8 s, of which the hold is none. */
    @Test
    void theBreathsAroundAHoldChangeInTheProportionOfTheHeldOne() {
        BreathingPreset hold = BreathingPreset.named("hold-inspiration");
        BreathingParameters changed = hold.parameters()
                .withRatePerMin(15)
                .withInspiratoryFraction(0.225)
                .withChestShare(0.25);
        BreathingPattern pattern = hold.pattern(changed, 0.5);
        // Ti of a quiet breath is 0.4 of 4 s, so now 0.2 of 2 s; half as deep, the diaphragm has half as much again.
        assertThat(BreathingPatternContract.at(pattern, 0.4).activation).isCloseTo(0.5 * 1.5 * 0.26, within(1e-12));
        assertThat(BreathingPatternContract.at(pattern, 0.4).ribTurn).isCloseTo(0.5 * 0.5 / 6, within(1e-4));
        assertThat(BreathingPatternContract.at(pattern, 2.001).breath).isEqualTo(1);
        assertThat(BreathingPatternContract.at(pattern, 4 + 0.9).activation).isCloseTo(0.75, within(1e-12));
        // Rates beyond the greatest that there is are the greatest.
        BreathingPattern fast = hold.pattern(hold.parameters().withRatePerMin(150));
        assertThat(BreathingPatternContract.at(fast, 0.401).breath).isEqualTo(1);
    }

    @Test
    void badPresetsAreRefusedInOneSentence() {
        assertThatThrownBy(() -> BreathingPreset.named("yawn"))
                .hasMessageStartingWith("breathing: no preset 'yawn', expected quiet, quiet-supine, deep");
        refused(
                QUIET.replace("0.26", "1.26"),
                "q.yaml: line 6, key 'activation': found '1.26', expected a number from 0 to 1");
        refused(QUIET.replace("0.26", "much"), "q.yaml: line 6, key 'activation': found 'much', expected a number");
        refused(
                QUIET.replace("pressure: 0.06\n", ""),
                "q.yaml: line 1, key 'pressure': found no such key, expected a number from 0 to 1");
        refused(
                QUIET.replace("periodic", "odd"),
                "q.yaml: line 2, key 'kind': found 'odd', expected periodic, hold, cough or waxing");
        refused("", "q.yaml: no keys, expected lines of 'key: value'");
        assertThatThrownBy(() -> preset(QUIET + "depth: 3\n"))
                .hasMessageStartingWith(
                        "q.yaml: line 10, key 'depth': found an unknown key, expected one of name, kind, rate_per_min");
        assertThatThrownBy(() -> preset(QUIET + "name: r\n"))
                .hasMessageContaining("q.yaml")
                .hasMessageContaining("key 'name': found the key a second time");
        refused(
                QUIET.replace("inspiratory_fraction: 0.4", "inspiratory_fraction: 0.95"),
                "q.yaml: breath: inspiratory fraction 0.95 and pause fraction 0.1, expected an inspiratory fraction above "
                        + "0, a pause fraction from 0, and a sum below 1");
        refused(
                QUIET.replace("rate_per_min: 15", "rate_per_min: 0"),
                "q.yaml: line 3, key 'rate_per_min': found '0', expected a number above 0 to 150");
    }

    private static void refused(String yaml, String message) {
        assertThatThrownBy(() -> preset(yaml))
                .isInstanceOf(BadInputException.class)
                .hasMessage(message);
    }

    private static BreathingPreset preset(String yaml) {
        return BreathingPreset.read(YamlDocument.parse("q.yaml", yaml), "q.yaml");
    }
}
