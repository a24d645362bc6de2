package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

/** The file that the window is opened with. */
class WindowStartTest {
    @TempDir
    Path folder;

    private WindowStart.Content content(String name, String text) throws Exception {
        return WindowStart.content(Optional.of(Files.writeString(folder.resolve(name), text)));
    }

    @Test
    void aRehearsalPlanIsOpenedAsOne() throws Exception {
        WindowStart.Content content =
                content("plan.yaml", "title: A plan\ntarget: {rest_mm: [-90, 0, 45], diameter_mm: 14}\n");
        assertThat(content.plan().orElseThrow().title()).isEqualTo("A plan");
        assertThat(content.scenario()).isEqualTo(Scenario.defaults());
    }

    @Test
    void aScenarioIsWhatBreathesFirst() throws Exception {
        WindowStart.Content content = content("deep.yaml", "preset: deep\n");
        assertThat(content.plan()).isEmpty();
        assertThat(content.scenario().preset()).isEqualTo("deep");
        assertThatThrownBy(() -> content("wrong.yaml", "no_such_key: 1\n")).isInstanceOf(BadInputException.class);
    }
}
