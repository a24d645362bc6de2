package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.simulation.observe.Observation;

/** Changes between the phases of a breath, and peak-to-peak values beside them. */
class RunSummaryTest {
    private static final int SAMPLES_PER_BREATH = 80;

    /** Breaths in which the domes go down by 15 mm and lung volume, of 400 ml peak to peak, lags by a phase angle. */
    private static List<Observation> breaths(int count, double lagDegrees) {
        List<Observation> samples = new ArrayList<>();
        for (int i = 0; i <= count * SAMPLES_PER_BREATH; i++) {
            double phase = 2 * Math.PI * i / SAMPLES_PER_BREATH;
            double[] values = new double[Observation.COLUMNS.size()];
            values[Observation.COLUMNS.indexOf("breath")] = i / SAMPLES_PER_BREATH;
            values[Observation.COLUMNS.indexOf("dome_right_mm")] = -7.5 * (1 - Math.cos(phase));
            values[Observation.COLUMNS.indexOf("dome_left_mm")] = -7.5 * (1 - Math.cos(phase));
            values[Observation.COLUMNS.indexOf("lung_volume_change_ml")] =
                    200 * (1 - Math.cos(phase - Math.toRadians(lagDegrees)));
            samples.add(new Observation(values));
        }
        return samples;
    }

    /** 5,000 steps of 1.2 ms are the number next below 6 s: the last breath ends with the step after them. */
    @Test
    void aRunEndsNoEarlierThanItsLastBreath() {
        assertThat(SimulationRun.stepsFor(6, 0.0012)).isEqualTo(5001);
        assertThat(SimulationRun.stepsFor(6, 0.00125)).isEqualTo(4800);
        assertThat(SimulationRun.stepsFor(0, 0.0012)).isZero();
    }

    @Test
    void whatGoesWithTheDomesHasEqualChangeAndPeakToPeakValue() {
        Map<String, Object> summary = new RunSummary(breaths(2, 0)).toMap();
        assertThat((double) summary.get("dome_excursion_right_mm")).isCloseTo(15, within(1e-9));
        assertThat((double) summary.get("dome_excursion_right_peak_to_peak_mm")).isCloseTo(15, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_ml")).isCloseTo(400, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_peak_to_peak_ml")).isCloseTo(400, within(1e-9));
    }

    /** A quarter of a breath behind, the volume is the same at both phases of the domes, yet it swings by 400 ml. */
    @Test
    void aLagHalvesNothingOfThePeakToPeakValue() {
        Map<String, Object> summary = new RunSummary(breaths(3, 90)).toMap();
        assertThat((double) summary.get("lung_volume_change_ml")).isCloseTo(0, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_peak_to_peak_ml")).isCloseTo(400, within(1e-9));
    }
}
