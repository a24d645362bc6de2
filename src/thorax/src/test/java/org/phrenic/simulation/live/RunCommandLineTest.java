package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.scenario.Scenario;

class RunCommandLineTest {
    /** Defaults of some keys depend on others: a value that is left out has to be the default beside those stated. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "depth=0.8",
                "time_step_s=0.01",
                "time_step_s=0.01 refresh_s=0.02",
                "material=paper time_step_s=0.005 refresh_s=0.04",
                "material=paper refresh_s=0.02",
                "material=published resolution=low",
                "preset=deep rate_per_min=10"
            })
    void theSettingsOfTheLineGiveTheScenario(String settings) {
        Scenario stated = Scenario.defaults().with(settings.split(" "));
        String[] words = RunCommandLine.of(stated).split(" ");
        Scenario typed = Scenario.defaults();
        for (int w = 2; w < words.length; w += 2) {
            assertThat(words[w]).isEqualTo("--set");
            typed = typed.with(words[w + 1]);
        }
        assertThat(typed).isEqualTo(stated);
    }
}
