package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.ui.access.IdleRehearsal;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.window.WindowHarness;

/** The list of exercises, into which plans come that are opened. */
class ExercisePanelTest {
    @TempDir
    Path folder;

    private RehearsalPlan plan(String attempt, String title, String target) throws IOException {
        Path file = Files.createDirectories(folder.resolve(attempt)).resolve("plan.yaml");
        return RehearsalPlan.read(Files.writeString(
                file,
                "title: " + title + "\nset: {resolution: low}\ntarget: {rest_mm: [" + target
                        + "], diameter_mm: 20}\nsteps: []\n"));
    }

    private static String opened(RehearsalController rehearsal) {
        return rehearsal.exercise().orElseThrow().file();
    }

    /** Two attempts that were saved, and one on a shipped exercise, have the titles of others. */
    @Test
    void ofExercisesOfOneTitleTheOneThatIsChosenIsOpened() throws IOException {
        RehearsalPlan first = plan("first", "Practice", "-90, 0, 50");
        RehearsalPlan second = plan("second", "Practice", "-80, 0, 60");
        RehearsalPlan shipped = RehearsalPlan.exercises().get(0);
        RehearsalPlan saved = plan("saved", shipped.title() + "\ndifficulty: " + shipped.difficulty(), "-80, 0, 60");
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            ExercisePanel panel = new ExercisePanel(session, rehearsal);
            JComboBox<?> list =
                    WindowHarness.find(panel, JComboBox.class, "Exercise").orElseThrow();
            int before = list.getItemCount();
            assertThat(list.getItemAt(1)).hasToString(shipped.title() + " (" + shipped.difficulty() + ")");
            rehearsal.open(first);
            rehearsal.open(second);
            assertThat(list.getSelectedIndex()).isEqualTo(before + 1);
            assertThat(list.getItemAt(before)).hasToString("Practice, " + Path.of("first", "plan.yaml"));
            rehearsal.open(saved);
            list.setSelectedIndex(before + 1);
            assertThat(opened(rehearsal)).isEqualTo(second.file());
            list.setSelectedIndex(before);
            assertThat(opened(rehearsal)).isEqualTo(first.file());
            list.setSelectedIndex(before + 2);
            assertThat(opened(rehearsal)).isEqualTo(saved.file());
            list.setSelectedIndex(1);
            assertThat(opened(rehearsal)).isEqualTo(shipped.file());
        });
    }
}
