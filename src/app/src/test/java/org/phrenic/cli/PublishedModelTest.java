package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.PaperScenarios;

/** One word gives the published model: the same bits from the command line, the window and {@code reproduce}. */
class PublishedModelTest {
    private static final int STEPS = 5;
    private static final Pattern HASH = Pattern.compile("\"state_sha256\"\\s*:\\s*\"([0-9a-f]{64})\"");

    private static String hashOfCommand(String... options) {
        String[] arguments = new String[options.length + 6];
        System.arraycopy(
                new String[] {"run", "--json", "--resolution", "low", "--steps", "" + STEPS}, 0, arguments, 0, 6);
        System.arraycopy(options, 0, arguments, 6, options.length);
        CommandLineRun run = CommandLineRun.of(arguments);
        Matcher matcher = HASH.matcher(run.out());
        assertThat(matcher.find()).as(run.out() + run.err()).isTrue();
        assertThat(run.out()).contains("\"integrator\": \"rk2\"", "\"material\": \"published\"");
        return matcher.group(1);
    }

    private static String hashOf(Scenario scenario) {
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
            }
            return simulation.stateHash();
        }
    }

    @Test
    void windowCommandLineAndReproductionComputeTheSameBits() {
        Scenario inWindow = Scenario.defaults().with("resolution=low").withMaterial(Materials.PUBLISHED);
        String hash = hashOf(inWindow);
        assertThat(hashOfCommand("--preset", "paper", "--threads", "1")).isEqualTo(hash);
        assertThat(hashOfCommand("data/scenarios/published.yaml", "--threads", "2"))
                .isEqualTo(hash);
        assertThat(PaperScenarios.publishedModel("quiet", Resolution.LOW)).isEqualTo(inWindow);
        assertThat(PaperScenarios.scheme(inWindow)).isEqualTo("rk2, 10 ms");
    }
}
