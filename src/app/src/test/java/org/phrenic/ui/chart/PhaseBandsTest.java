package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.BreathState;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.simulation.observe.Observation;

class PhaseBandsTest {
    private static final double STEP_S = 0.02;

    private static SampleRingBuffer recorded(String preset, double seconds) throws Exception {
        return recorded(preset, seconds, 0);
    }

    private static SampleRingBuffer recorded(double... sums) {
        SampleRingBuffer ring = new SampleRingBuffer(Observation.COLUMNS.size(), 5000);
        for (int i = 0; i < sums.length; i++) {
            double[] values = new double[Observation.COLUMNS.size()];
            values[Observation.COLUMNS.indexOf("activation")] = sums[i];
            ring.add(i * STEP_S, values);
        }
        return ring;
    }

    /** @param ripple amplitude of a vibration of 6 Hz on the drive of the muscle, as noise of a camera has it */
    private static SampleRingBuffer recorded(String preset, double seconds, double ripple) throws Exception {
        BreathingPattern pattern = BreathingPreset.named(preset).pattern();
        BreathState state = new BreathState();
        SampleRingBuffer ring = new SampleRingBuffer(Observation.COLUMNS.size(), 5000);
        for (int i = 0; i * STEP_S <= seconds; i++) {
            pattern.at(i * STEP_S, state);
            double[] values = new double[Observation.COLUMNS.size()];
            values[Observation.COLUMNS.indexOf("breath")] = state.breath;
            values[Observation.COLUMNS.indexOf("activation")] =
                    state.activation + ripple * Math.sin(12 * Math.PI * i * STEP_S);
            values[Observation.COLUMNS.indexOf("rib_turn")] = state.ribTurn;
            ring.add(i * STEP_S, values);
        }
        return ring;
    }

    @Test
    void twoQuietBreathsAreInspirationExpirationAndPauseTwice() throws Exception {
        List<PhaseBands.Band> bands = PhaseBands.of(recorded("quiet", 7.9), 0, 7.9);
        assertThat(bands.stream().map(PhaseBands.Band::label).filter(l -> l != RespiratoryPhase.PAUSE))
                .containsExactly(
                        RespiratoryPhase.INSPIRATION,
                        RespiratoryPhase.EXPIRATION,
                        RespiratoryPhase.INSPIRATION,
                        RespiratoryPhase.EXPIRATION);
        // Quiet: 4 s, of which inspiration takes 0.4.
        PhaseBands.Band first = bands.stream()
                .filter(b -> b.label() == RespiratoryPhase.EXPIRATION)
                .findFirst()
                .orElseThrow();
        assertThat(first.from()).isCloseTo(1.6, within(0.1));
        for (int i = 1; i < bands.size(); i++) {
            assertThat(bands.get(i).from()).isEqualTo(bands.get(i - 1).to());
        }
    }

    /** A ripple of 0.01 beats the slope of the drives at every turn of the ripple. */
    @Test
    void noiseOnABreathIsNoPhase() throws Exception {
        List<PhaseBands.Band> bands = PhaseBands.of(recorded("quiet", 7.9, 0.01), 0, 7.9);
        int turns = 0;
        for (int i = 1; i < bands.size(); i++) {
            turns += bands.get(i).label() == bands.get(i - 1).label() ? 0 : 1;
        }
        // Up and down twice; the ripple hides the pauses, and the first samples before the first rise may be falling.
        assertThat(turns).isBetween(3, 5);
    }

    /** A recorded breath rises for 1 s, falls for 1 s and rests for 2 s, in which it trembles twice for 0.2 s. */
    @Test
    void aTremorInAPauseIsNoPhase() {
        double[] sums = new double[200];
        for (int i = 0; i < 100; i++) {
            sums[i] = 0.5 * (1 - Math.cos(2 * Math.PI * i / 100.0));
        }
        for (int i = 0; i < 10; i++) {
            double tremor = 0.004 * Math.sin(Math.PI * i / 10);
            sums[120 + i] = tremor;
            sums[150 + i] = tremor;
        }
        assertThat(PhaseBands.of(recorded(sums), 0, 4))
                .extracting(PhaseBands.Band::label)
                .containsExactly(RespiratoryPhase.INSPIRATION, RespiratoryPhase.EXPIRATION, RespiratoryPhase.PAUSE);
    }

    @Test
    void aBreathHeldAtInspirationIsAHold() throws Exception {
        assertThat(PhaseBands.of(recorded("hold-inspiration", 20), 0, 20))
                .anyMatch(b -> b.label() == RespiratoryPhase.HOLD && b.to() - b.from() > 4);
    }

    @Test
    void nothingRecordedHasNoBands() {
        assertThat(PhaseBands.of(new SampleRingBuffer(Observation.COLUMNS.size(), 10), 0, 1))
                .isEmpty();
    }
}
