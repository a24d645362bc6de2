package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;
import org.phrenic.simulation.SimulationRun;

/** A breath that is held for a fit, on the sheet alone. */
class InspiratoryHoldTest {
    private static final Scenario SHEET_ALONE = Scenario.defaults()
            .with(
                    "preset=deep",
                    "resolution=low",
                    "mesh_vertices=3000",
                    "lungs=off",
                    "sternum=off",
                    "liver=false",
                    "rib_rotation=0");

    private static final Thorax BODY = VirtualThorax.ofPreset("adult-male", new MeshBudget(3000));

    /**
     * Each material is observed when its held breath is near rest: the dome goes on by at most 2 % of its excursion
     * between the comparison of the search, at a third of the time, and the observation.
     */
    @ParameterizedTest
    @CsvSource({
        "physical, muscle_activation, 0.6, 1.1, 1.7",
        "paper, muscle_force_mn, 300, 10.8, 30.8",
    })
    void aMaterialIsObservedWhenItIsNearRest(
            String material, String key, double value, double searchedAtS, double observedAtS) {
        Scenario base = SHEET_ALONE.with("material=" + material);
        if (material.equals("paper")) {
            base = base.with("damping_ns_per_m=0.5");
        }
        assertThat(InspiratoryHold.searchedAtS(base)).isEqualTo(searchedAtS);
        assertThat(InspiratoryHold.observedAtS(base)).isEqualTo(observedAtS);
        FitParameter drive = FitParameter.of(Settings.parameter(key), base);
        try (InspiratoryHold hold = new InspiratoryHold(base, BODY, List.of(drive))) {
            assertThat(hold.breatheInForSearch(new double[] {value})).isEmpty();
            double early = hold.observed("dome_right_mm");
            assertThat(hold.breatheIn(new double[] {value})).isEmpty();
            double late = hold.observed("dome_right_mm");
            assertThat(late).as("the dome goes down by centimetres").isLessThan(-10);
            assertThat(early).isCloseTo(late, within(0.02 * Math.abs(late)));
        }
    }

    /** The time is no multiple of this step: a run takes the step that reaches beyond it. */
    @Test
    void aRunOfTheFittedScenarioEndsInTheStateThatWasObserved() {
        Scenario base = SHEET_ALONE.with("time_step_s=0.006");
        List<FitParameter> parameters = List.of(FitParameter.of(Settings.parameter("muscle_activation"), base));
        double[] values = {0.6};
        try (InspiratoryHold hold = new InspiratoryHold(base, BODY, parameters)) {
            assertThat(hold.breatheIn(values)).isEmpty();
            assertThat(SimulationRun.run(
                            InspiratoryHold.scenario(base, parameters, values), null, (at, of, perS) -> {}))
                    .containsEntry("state_sha256", hold.stateHash());
        }
    }
}
