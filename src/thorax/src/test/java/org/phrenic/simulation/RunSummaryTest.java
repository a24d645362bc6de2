package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
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

    private static final List<String> SHOWN = List.of(
            "breath",
            "dome_right_mm",
            "dome_left_mm",
            "central_tendon_mm",
            "liver_si_mm",
            "liver_ap_mm",
            "ap_change_mm",
            "from_rest_rms_mm",
            "rigid_link_error");

    /** A row for each of these columns. */
    private static final double[][] TWO_BREATHS = {
        {0, 0, 0, 0, 1, 1, 1, 2},
        {0, -10, -8, -2, 0, -4, -5, 0},
        {0, 0, -12, -1, 0, -6, -1, 0},
        {0, -1, -6, -7, 0, -2, -3, 0},
        {0, -9, -8, -1, 0, -4, -6, 0},
        {0, 1, 3, 4, 0, 1, 2, 0},
        {0, -2, -1, 0, 0, -3, -1, 0},
        {0, 4, 5, 2, 0.7, 6, 3, 0.2},
        {0, 2e-6, 0, 1e-5, 0, 0, 3e-6, 0},
    };

    private static final List<String> PLACES = Observation.COLUMNS.stream()
            .filter(column -> column.matches("(anterior|middle|posterior|lateral|medial)_(right|left)_mm"))
            .toList();

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
        Scenario scenario = Runs.scenario(Runs.sheetAlone("mesh_vertices=2000", "rate_per_min=150", "steps=750"))
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

    /** Two breaths: the columns of {@link #TWO_BREATHS}, and places of the domes that go down by their number. */
    private static List<Observation> twoBreaths() {
        List<Observation> samples = new ArrayList<>();
        for (int i = 0; i < TWO_BREATHS[0].length; i++) {
            double[] values = new double[Observation.COLUMNS.size()];
            values[Observation.COLUMNS.indexOf("time_s")] = i;
            for (int row = 0; row < TWO_BREATHS.length; row++) {
                values[Observation.COLUMNS.indexOf(SHOWN.get(row))] = TWO_BREATHS[row][i];
            }
            for (String column : PLACES) {
                int number = Observation.COLUMNS.indexOf(column);
                values[number] = i == 2 || i == 5 ? -number : 0;
            }
            samples.add(new Observation(values));
        }
        return samples;
    }

    /** The domes together are lowest at samples 2 and 5, the right one alone at samples 1 and 6. */
    @Test
    void changesAreMeansOverTheBreathsFromStartToLowestDomes() {
        Map<String, Object> summary = new RunSummary(twoBreaths(), List.of()).toMap();
        Map<String, Double> expected = new LinkedHashMap<>(Map.of(
                "dome_excursion_right_mm", 6.0,
                "dome_excursion_right_peak_to_peak_mm", 7.5,
                "dome_excursion_left_mm", 9.0,
                "dome_excursion_left_peak_to_peak_mm", 9.0,
                "central_tendon_excursion_mm", 4.0,
                "liver_si_mm", 6.0,
                "liver_ap_mm", 2.0,
                "ap_change_mm", -2.0,
                "rest_return_rms_mm", 0.7,
                "max_rigid_link_error", 1e-5));
        for (String column : PLACES) {
            expected.put(column.replaceFirst("_", "_excursion_"), (double) Observation.COLUMNS.indexOf(column));
        }
        expected.forEach(
                (key, value) -> assertThat((double) summary.get(key)).as(key).isCloseTo(value, within(1e-12)));
    }

    /** Such as a hold: the domes go down by 8 mm on the right in the samples that there are. */
    @Test
    void aRunWithoutAWholeBreathCountsAsOne() {
        Map<String, Object> summary = new RunSummary(twoBreaths().subList(0, 4), List.of()).toMap();
        assertThat(summary).containsEntry("breaths", 1);
        assertThat((double) summary.get("dome_excursion_right_mm")).isCloseTo(8, within(1e-12));
        // The end of the last breath is told as well.
        assertThat((double) new RunSummary(twoBreaths().subList(0, 5), List.of())
                        .toMap()
                        .get("rest_return_rms_mm"))
                .isCloseTo(0.7, within(1e-12));
    }
}
