package org.phrenic.cli.option;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;
import picocli.CommandLine;

class ScenarioOptionsTest {
    @TempDir
    private Path folder;

    private static Scenario of(String... arguments) {
        ScenarioOptions options = new ScenarioOptions();
        new CommandLine(options).parseArgs(arguments);
        return options.resolved();
    }

    @Test
    void thePublishedModelLeavesTheBreathingOfTheScenario() throws IOException {
        String file =
                Files.writeString(folder.resolve("s.yaml"), "preset: deep\n").toString();
        assertThat(of(file, "--preset", "paper").preset()).isEqualTo("deep");
        assertThat(of(file, "--preset", "paper").material()).isEqualTo(Materials.PUBLISHED);
        assertThat(of("--preset", "paper").preset()).isEqualTo("quiet");
        assertThat(of(file, "--preset", "quiet").material()).isEqualTo(Materials.PHYSICAL);
    }
}
