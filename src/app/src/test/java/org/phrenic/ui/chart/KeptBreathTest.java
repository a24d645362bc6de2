package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.simulation.observe.Observation;

class KeptBreathTest {
    private static final int DOME = Observation.COLUMNS.indexOf("dome_right_mm");
    private static final double STEP_S = 0.02;

    /** Breaths whose dome descends and comes back by (1 - cos(2 pi phase)) / 2 of a swing. */
    private static SampleRingBuffer breathing(double periodS, double swingMm, double seconds) {
        SampleRingBuffer ring = new SampleRingBuffer(Observation.COLUMNS.size(), 5000);
        for (int i = 0; i * STEP_S <= seconds; i++) {
            double breaths = i * STEP_S / periodS;
            double[] values = new double[Observation.COLUMNS.size()];
            values[Observation.COLUMNS.indexOf("breath")] = Math.floor(breaths);
            values[KeptBreath.PHASE] = breaths - Math.floor(breaths);
            values[DOME] = -swingMm * (1 - Math.cos(2 * Math.PI * breaths)) / 2;
            ring.add(i * STEP_S, values);
        }
        return ring;
    }

    @Test
    void theLastWholeBreathIsAFunctionOfPhaseWhateverItsPeriod() {
        for (double periodS : new double[] {1.5, 4}) {
            KeptBreath kept =
                    KeptBreath.last("A", breathing(periodS, 12, 10), 0).orElseThrow();
            // Linear between samples at most 0.0134 of a breath apart: 12 / 2 (2 pi 0.0134)^2 / 8 = 0.005 mm.
            assertThat(kept.value(DOME, 0.25)).isCloseTo(-6, within(0.006));
            assertThat(kept.value(DOME, 0.5)).isCloseTo(-12, within(0.006));
            assertThat(kept.value(DOME, 1)).isCloseTo(0, within(0.03));
            assertThat(kept.peakToPeak(DOME)).isCloseTo(12, within(0.02));
        }
    }

    @Test
    void aBreathThatBeganBeforeTheChangeIsNotKept() {
        // Breaths begin at 0, 4 and 8 s; the last whole one is that from 4 to 8 s.
        SampleRingBuffer ring = breathing(4, 12, 10);
        assertThat(KeptBreath.last("A", ring, 3.9)).isPresent();
        assertThat(KeptBreath.last("A", ring, 4.1)).isEmpty();
        assertThat(KeptBreath.last("A", breathing(4, 12, 3.9), 0)).isEmpty();
        assertThat(KeptBreath.last("A", new SampleRingBuffer(Observation.COLUMNS.size(), 10), 0))
                .isEmpty();
    }

    @Test
    void theDifferenceIsThePresentLessTheKept() {
        KeptBreath kept = KeptBreath.last("A: quiet", breathing(4, 12, 10), 0).orElseThrow();
        Optional<KeptBreath> present = KeptBreath.last("", breathing(2, 20, 10), 0);
        List<PlotCurve> curves = PlotCurve.ofObservables().subList(0, 1);
        BreathComparison comparison = BreathComparison.of(curves, kept, present);
        assertThat(comparison.rows()).hasSize(1);
        assertThat(comparison.rows().get(0).difference()).isCloseTo(8, within(0.05));
        assertThat(comparison.html()).contains("A: quiet", "Dome right (mm)", "12.0", "20.0", "+8.0");
        assertThat(BreathComparison.of(curves, kept, Optional.empty()).html())
                .contains("12.0")
                .contains("-");
    }
}
