package org.phrenic.model.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.scenario.Scenario;

/** Which breath it is, and where in it, after a change of the pattern during a run. */
class LiveBreathingTest {
    private static final long STEP = 400;

    private static BreathState at(BreathingPattern pattern, double timeS) {
        BreathState state = new BreathState();
        pattern.at(timeS, state);
        return state;
    }

    private static LiveBreathing breathing(String... settings) {
        return new LiveBreathing(Scenario.defaults().with(settings));
    }

    private static BreathingPattern pattern(String... settings) {
        return Breathing.patternOf(Scenario.defaults().with(settings));
    }

    /** Sixteen breaths of 2.5 s, with an apnoea of 20 s; two of 4 s before a longer one that is held for 24 s. */
    @ParameterizedTest
    @CsvSource({
        "cheyne-stokes, 0, 60, 2.5",
        "cheyne-stokes, 60, 85, 2.5",
        "cheyne-stokes, 0, 2.4, 2.4",
        "hold-inspiration, 0, 40, 4",
        "hold-inspiration, 8, 40, 32",
        "hold-expiration, 0, 40, 4",
        "quiet, 0, 4, 4",
        "quiet, 0, 3.9, 3.9"
    })
    void theShortestBreathIsFound(String preset, double fromS, double toS, double shortestS) {
        assertThat(breathing("preset=" + preset).shortestBreathS(fromS, toS)).isCloseTo(shortestS, within(1e-3));
    }

    /** Breaths of 4 s, whose expiration is over after 3.4 s. */
    @ParameterizedTest
    @CsvSource({"0, 0, false", "0.5, 1, true", "3.3, 1, true", "3.9, 1, false", "4, 1, false", "6, 2, true"})
    void anotherPresetEndsTheBreathUnlessItOnlyBegins(double nowS, int breath, boolean cutShort) {
        LiveBreathing quiet = breathing();
        quiet.change(pattern("preset=deep"), true, STEP, nowS);
        assertThat(at(quiet, nowS + 0.01).breath).isEqualTo(breath);
        assertThat(at(quiet, nowS + 0.01).phase).isCloseTo(0.01 / 8, within(1e-12));
        assertThat(quiet.cutShortS()).isEqualTo(cutShort ? List.of(nowS) : List.of());
        // Of two changes at one step the second applies.
        quiet.change(pattern("preset=sniff"), true, STEP, nowS);
        assertThat(at(quiet, nowS + 0.01).breath).isEqualTo(breath);
        assertThat(quiet.cutShortS()).hasSize(cutShort ? 1 : 0);
    }

    @Test
    void itLastsAsLongAsTheLastPatternThatWasSet() {
        LiveBreathing hold = breathing("preset=hold-inspiration");
        double wholeS = hold.fullDurationS();
        assertThat(wholeS).isFinite();
        hold.change(pattern("preset=hold-inspiration", "depth=0.5"), false, STEP, 2);
        assertThat(hold.fullDurationS()).isEqualTo(wholeS);
    }

    /** Held at 3.5 s, when the expiration of the breath of 4 s is over; held at 2 s, it is not. */
    @ParameterizedTest
    @CsvSource({"3.5, false", "2, true"})
    void anotherPresetAfterAHoldCutsTheBreathShortThatWasHeldBeforeItsPause(double heldS, boolean cutShort) {
        LiveBreathing quiet = breathing();
        quiet.hold(true, heldS);
        quiet.hold(false, 6);
        quiet.change(pattern("preset=deep"), true, STEP, 6);
        assertThat(quiet.cutShortS()).isEqualTo(cutShort ? List.of(6.0) : List.of());
    }

    /** The last of 16 breaths ends after 40 s; the apnoea that follows counts as part of it. */
    @Test
    void anotherPresetInAnApnoeaCutsNoBreathShort() {
        LiveBreathing waxing = breathing("preset=cheyne-stokes");
        waxing.change(pattern("preset=deep"), true, STEP, 45);
        assertThat(at(waxing, 45.01).breath).isEqualTo(16);
        assertThat(waxing.cutShortS()).isEmpty();
    }

    /**
     * Half the rate: 16 breaths of a cycle take 80 s instead of 40 s, the apnoea 20 s as before. Twice the rate around
     * a hold of 24 s: from 5.8 s on instead of 11.6 s. A cough of 6 s, then of 3 s, has 0.2 s of compression and 0.8 s
     * of expulsion and recovery, as before.
     */
    @ParameterizedTest
    @CsvSource({
        "cheyne-stokes, 12, 10, 20",
        "cheyne-stokes, 12, 50, 90",
        "cheyne-stokes, 12, 61.25, 102.5",
        "hold-inspiration, 15, 1, 0.5",
        "hold-inspiration, 15, 9.8, 4.9",
        "hold-inspiration, 15, 20, 14.2",
        "hold-inspiration, 15, 37.8, 30.9",
        "hold-inspiration, 15, 49, 36.5",
        "hold-expiration, 30, 2, 1",
        "hold-expiration, 30, 20, 16",
        "hold-expiration, 30, 37, 30.5",
        "cough, 20, 0.45, 0.225",
        "cough, 20, 1, 0.55",
        "cough, 20, 1.25, 0.8",
        "cough, 20, 9.95, 5.225",
    })
    void anotherRateGoesOnAtTheSamePlaceInBreathHoldOrApnoea(String preset, int rate, double nowS, double intoS) {
        LiveBreathing breathing = breathing("preset=" + preset);
        BreathState before = at(breathing, nowS);
        breathing.change(pattern("preset=" + preset, "rate_per_min=" + rate), false, STEP, nowS);
        assertThat(breathing.patternTimeS(nowS)).isCloseTo(intoS, within(1e-9));
        BreathState after = at(breathing, nowS);
        assertThat(after.breath).isEqualTo(before.breath);
        assertThat(after.respiratoryPhase).isEqualTo(before.respiratoryPhase);
        assertThat(after.activation).isCloseTo(before.activation, within(1e-9));
        assertThat(breathing.cutShortS()).isEmpty();
    }
}
