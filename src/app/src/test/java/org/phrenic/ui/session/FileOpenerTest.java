package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
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
    }

    @Test
    void aPlanIsToldByItsListOfSteps() throws IOException {
        Path file = Files.writeString(folder.resolve("plan.yaml"), "steps:\n- wait: end-expiration of breath 2\n");
        assertThatThrownBy(() -> FileOpener.readPlan(file)).hasMessageContaining("key 'target'");
    }
}
