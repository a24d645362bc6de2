package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.observe.Observation;

/** Changes between the phases of a breath, and peak-to-peak values beside them. */
class RunSummaryTest {
    private static final int SAMPLES_PER_BREATH = 80;

    /** Breaths in which the domes go down by 15 mm and lung volume, of 400 ml peak to peak, lags by a phase angle. */
    private static List<Observation> breaths(int count, double lagDegrees) {
        List<Observation> samples = new ArrayList<>();
        for (int i = 0; i <= count * SAMPLES_PER_BREATH; i++) {
            samples.add(sample(i, i / SAMPLES_PER_BREATH, i, lagDegrees));
        }
        return samples;
    }

    private static Observation sample(double timeS, int breath, int into, double lagDegrees) {
        double phase = 2 * Math.PI * into / SAMPLES_PER_BREATH;
        double[] values = new double[Observation.COLUMNS.size()];
        values[Observation.COLUMNS.indexOf("time_s")] = timeS;
        values[Observation.COLUMNS.indexOf("breath")] = breath;
        values[Observation.COLUMNS.indexOf("dome_right_mm")] = -7.5 * (1 - Math.cos(phase));
        values[Observation.COLUMNS.indexOf("dome_left_mm")] = -7.5 * (1 - Math.cos(phase));
        values[Observation.COLUMNS.indexOf("lung_volume_change_ml")] =
                200 * (1 - Math.cos(phase - Math.toRadians(lagDegrees)));
        return new Observation(values);
    }

    /** Of three breaths the second ends at a quarter, by another preset. */
    @Test
    void aBreathThatIsCutShortIsNoWholeOne() {
        List<Observation> samples = breaths(1, 0);
        for (int i = 81; i < 100; i++) {
            samples.add(sample(i, 1, i - 80, 0));
        }
        for (int i = 100; i <= 180; i++) {
            samples.add(sample(i, 2 + (i - 100) / SAMPLES_PER_BREATH, i - 100, 0));
        }
        for (double changedS : new double[] {99, 99.5}) {
            Map<String, Object> summary = new RunSummary(samples, List.of(changedS)).toMap();
            assertThat(summary).containsEntry("breaths", 2);
            assertThat((double) summary.get("dome_excursion_right_mm")).isCloseTo(15, within(1e-9));
            assertThat((double) summary.get("dome_excursion_right_peak_to_peak_mm"))
                    .isCloseTo(15, within(1e-9));
        }
        // Between two samples the whole breath ended, and one that had hardly begun.
        List<Observation> two = breaths(1, 0).subList(0, SAMPLES_PER_BREATH);
        two.add(sample(80, 2, 0, 0));
        assertThat(new RunSummary(two, List.of(79.9)).toMap()).containsEntry("breaths", 1);
        assertThat((double) new RunSummary(two, List.of(79.9)).toMap().get("dome_excursion_left_mm"))
                .isCloseTo(15, within(1e-9));
    }

    /** Breaths of 0.4 s are 320 steps. */
    @ParameterizedTest
    @CsvSource({"320, 2", "400, 2"})
    void aRunWithAChangeOfPresetAveragesOverItsWholeBreaths(int step, int breaths) {
        Scenario scenario = Runs.scenario(Runs.sheetAlone("rate_per_min=150", "steps=750"))
                .withChanges(List.of(ScheduledChange.parse(step + ":preset=rapid-shallow")));
        SimulationRun.Progress quiet = (simulated, total, perS) -> {};
        assertThat(SimulationRun.run(scenario, null, quiet)).containsEntry("breaths", breaths);
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
        Map<String, Object> summary = new RunSummary(breaths(2, 0), List.of()).toMap();
        assertThat((double) summary.get("dome_excursion_right_mm")).isCloseTo(15, within(1e-9));
        assertThat((double) summary.get("dome_excursion_right_peak_to_peak_mm")).isCloseTo(15, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_ml")).isCloseTo(400, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_peak_to_peak_ml")).isCloseTo(400, within(1e-9));
    }

    /** A quarter of a breath behind, the volume is the same at both phases of the domes, yet it swings by 400 ml. */
    @Test
    void aLagHalvesNothingOfThePeakToPeakValue() {
        Map<String, Object> summary = new RunSummary(breaths(3, 90), List.of()).toMap();
        assertThat((double) summary.get("lung_volume_change_ml")).isCloseTo(0, within(1e-9));
        assertThat((double) summary.get("lung_volume_change_peak_to_peak_ml")).isCloseTo(400, within(1e-9));
    }
}
