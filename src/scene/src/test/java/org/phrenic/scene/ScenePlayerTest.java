package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

class ScenePlayerTest {
    /** 0.05 s of steps of 1.25 ms, then steps of 0.5 ms. */
    private static final Scenario CHANGED = Scenario.defaults()
            .with("resolution=low", "lungs=off", "liver=false", "sternum=kinematic", "time_step_s=0.00125")
            .withChanges(List.of(ScheduledChange.parse("40:time_step_s=0.0005")));

    /** Of which 0.2 s are made. */
    private static final int STEPS = 40 + 300;

    @Test
    void timesAreSimulatedTimesWhateverTheStepAndTheStateIsThatOfARun() {
        try (ScenePlayer player = new ScenePlayer(CHANGED, (at, of, rate) -> {})) {
            for (double timeS : new double[] {0.02, 0.05, 0.08, 0.2}) {
                Frame frame = player.advanceTo(timeS);
                assertThat(frame.timeS()).isCloseTo(timeS, within(1e-9));
            }
            assertThatThrownBy(() -> player.advanceTo(0.1)).hasMessageContaining("expected times in order");
            String run = SimulationRun.run(CHANGED.with("steps=" + STEPS), null, (at, of, rate) -> {})
                    .get("state_sha256")
                    .toString();
            assertThat(player.stateHash())
                    .as("where a run of as many steps ends")
                    .isEqualTo(run);
        }
    }
}
