package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

class FileOpenerTest {
    @TempDir
    private Path folder;

    /** A run writes the scenario of what it did, with the number of steps, and the window opens it. */
    @Test
    void aScenarioThatStatesItsStepsIsNoPlan() throws IOException {
        Path file = Files.writeString(folder.resolve("scenario.yaml"), "name: a run\ndepth: 0.8\nsteps: 500\n");
        assertThat(FileOpener.readPlan(file)).isEmpty();
        assertThat(FileOpener.readScenario(file, Scenario.defaults()).steps()).isEqualTo(500);
        Files.writeString(file, "preset: quiet\nsteps: 10 000\n");
        assertThat(FileOpener.readPlan(file)).isEmpty();
        assertThatThrownBy(() -> FileOpener.readScenario(file, Scenario.defaults()))
                .hasMessageContaining("found '10 000', expected a whole number");
    }

    @Test
    void aPlanIsToldByItsListOfSteps() throws IOException {
        Path file = Files.writeString(folder.resolve("plan.yaml"), "steps:\n- wait: end-expiration of breath 2\n");
        assertThatThrownBy(() -> FileOpener.readPlan(file)).hasMessageContaining("key 'target'");
    }

    @Test
    void aRecordingThatDoesNotBreatheIsRefused() throws IOException {
        Path flat = Files.writeString(folder.resolve("flat.csv"), "time_s,amplitude\n" + samples(1, 3));
        assertThatThrownBy(() -> FileOpener.readScenario(flat, Scenario.defaults()))
                .isInstanceOf(BadInputException.class)
                .hasMessage(flat + ": the signal stays at 1.0, expected breathing");
        Path brief = Files.writeString(folder.resolve("brief.csv"), "time_s,amplitude\n" + samples(10, 0.1));
        assertThatThrownBy(() -> FileOpener.readScenario(brief, Scenario.defaults()))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith(brief.toString())
                .hasMessageContaining("expected more than 1.0 s");
    }

    /** Ten samples whose values repeat after so many. */
    private static String samples(int values, double everyS) {
        return IntStream.range(0, 10)
                .mapToObj(i -> i * everyS + "," + (1 + i % values) + "\n")
                .collect(Collectors.joining());
    }
}
