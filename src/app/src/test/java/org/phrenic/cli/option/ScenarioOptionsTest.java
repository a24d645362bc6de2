package org.phrenic.cli.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
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

    private String file(String text) throws IOException {
        return Files.writeString(folder.resolve("s.yaml"), text).toString();
    }

    @Test
    void thePublishedModelIsTheSameWhateverSchemeAScenarioStates() throws IOException {
        Path written = folder.resolve("scenario.yaml");
        YamlWriter.write(written, of("--material", "paper").toMap());
        Scenario published = of("--preset", "paper");
        assertThat(of(written.toString(), "--preset", "paper")).isEqualTo(published);
        assertThat(of(written.toString(), "--material", "published")).isEqualTo(published);
        YamlWriter.write(written, of().toMap());
        assertThat(of(written.toString(), "--preset", "paper")).isEqualTo(published);
        String other = file("name: quiet\nintegrator: backward-euler\ntime_step_s: 0.02\ntendon: trefoil\n");
        assertThat(of(other, "--preset", "paper")).isEqualTo(published);
        assertThat(of(other, "--preset", "paper", "--integrator", "rk4").integrator())
                .isEqualTo(IntegratorKind.RK4);
        assertThat(of(other, "--material", "published").integrator()).isEqualTo(IntegratorKind.BACKWARD_EULER);
    }

    @Test
    void aDurationOfTheCommandLineReplacesTheStepsOfAScenario() throws IOException {
        String file = file("steps: 500\n");
        assertThat(of(file).steps()).isEqualTo(500);
        Scenario lasting = of(file, "--duration", "2");
        assertThat(lasting.steps()).isEqualTo(-1);
        assertThat(lasting.durationS()).isEqualTo(2);
        assertThat(of(file, "--set", "duration_s=2").steps()).isEqualTo(-1);
        assertThat(of(file, "--duration", "2", "--steps", "7").steps()).isEqualTo(7);
    }

    @Test
    void aBodyInPlaceOfAScenarioIsTheOnlyOne() {
        String body = folder.toString();
        assertThat(of(body).anatomy()).isEqualTo(body);
        for (List<String> other : List.of(
                List.of("--anatomy", "virtual/adult-female"), List.of("--set", "anatomy=virtual/adult-female"))) {
            assertThatExceptionOfType(BadInputException.class)
                    .isThrownBy(() -> of(body, other.get(0), other.get(1)))
                    .withMessage(String.join(" ", other) + ": found another body than " + body
                            + ", which is given in place of a scenario, expected one of them");
        }
    }
}
