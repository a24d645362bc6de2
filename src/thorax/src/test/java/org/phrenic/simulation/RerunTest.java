package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** A body that is breathed again with other changes does what one that was put together for them does. */
class RerunTest {
    private static final Scenario SCENARIO =
            Scenario.defaults().with("resolution=low", "preset=deep", "rate_per_min=30", "threads=1");
    private static final int STEPS = 60;

    private static List<ScheduledChange> changes(String... texts) {
        return java.util.Arrays.stream(texts).map(ScheduledChange::parse).toList();
    }

    private static String run(Simulation simulation) {
        while (simulation.steps() < STEPS) {
            simulation.step();
        }
        return simulation.stateHash();
    }

    @Test
    void givesTheBitsOfANewSimulationWithTheChangesWhateverWasChangedBefore() {
        List<ScheduledChange> all = changes(
                "0:muscle_activation=0.5",
                "0:muscle_stiffness_n_per_m=400",
                "0:tendon_stiffness_ratio=6",
                "0:rest_pressure_kpa=0.4",
                "0:left_over_right=0.8",
                "0:lung_stiffness_n_per_m=8",
                "0:sternum_coupling=1.5",
                "0:damping_rate_per_s=14",
                "0:rib_rotation=0.7",
                "0:front_over_back=1.4",
                "0:pressure_left_over_right=0.7",
                "0:upper_rib_rotation=0.8",
                "0:lower_rib_rotation=1.3",
                "0:rib_left_over_right=0.9",
                "0:bucket_handle=0.6",
                "0:mediastinum_left_mm=8",
                "40:hold=true");
        Thorax thorax = Runs.male();
        String fresh;
        String freshOther;
        List<ScheduledChange> other = changes("0:muscle_activation=0.3", "10:depth=0.5");
        try (Simulation simulation = Simulation.of(SCENARIO.withChanges(all), thorax)) {
            fresh = run(simulation);
            simulation.rerun(other);
            freshOther = run(simulation);
        }
        try (Simulation simulation = Simulation.of(SCENARIO.withChanges(other), thorax)) {
            assertThat(run(simulation)).isEqualTo(freshOther);
            simulation.rerun(all);
            assertThat(run(simulation)).isEqualTo(fresh);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> simulation.rerun(changes("0:contact=false")))
                    .withMessageContaining("contact");
        }
    }
}
