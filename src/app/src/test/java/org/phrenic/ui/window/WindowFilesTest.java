package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;

/** Files that are opened by menu or drop. */
class WindowFilesTest {
    @TempDir
    private Path folder;

    @Test
    void ofTwoFilesThatAreOpenedInSuccessionTheSecondCounts() throws IOException {
        Path first = Files.writeString(folder.resolve("first.yaml"), "name: first\nresolution: low\n");
        Path second = Files.writeString(folder.resolve("second.yaml"), "name: second\nresolution: low\n");
        List<Path> opened = new ArrayList<>();
        WindowPreferences preferences = WindowPreferences.unsaved();
        try (Session session =
                EventThread.get(() -> new Session(Scenario.defaults().with("resolution=low")))) {
            EventThread.run(() -> {
                session.addListener(new Session.Listener() {
                    @Override
                    public void onOpened(Path file, Scenario scenario) {
                        opened.add(file);
                    }
                });
                WindowFiles files = new WindowFiles(null, session, null, preferences, plan -> {}, null);
                files.open(first);
                files.open(second);
            });
            EventThread.until("the second file", () -> opened.contains(second));
            EventThread.run(() -> assertThat(opened).containsExactly(second));
            assertThat(preferences.recent()).as("what was read").containsExactly(second);
        }
    }

    @Test
    void whatClosingLosesIsAskedAboutByName() {
        assertThat(WindowFiles.lossQuestion(false, false, false)).isEmpty();
        assertThat(WindowFiles.lossQuestion(true, false, true))
                .hasValue("Closing now loses the import that is under way, and changed values that are not saved."
                        + " Close?");
        assertThat(WindowFiles.lossQuestion(false, true, false).orElseThrow())
                .contains("the attempt, whose needle is not out after its sample");
    }

    /** Each that is listed pushes out another one, which is of use. */
    @Test
    void whatIsRefusedIsNotListedAsOpened() throws IOException {
        Path picture = Files.createFile(folder.resolve("scan.png"));
        Path broken = Files.writeString(folder.resolve("broken.yaml"), "preset: unknown\n");
        Path empty = Files.createDirectory(folder.resolve("empty"));
        Path scenario = Files.writeString(folder.resolve("good.yaml"), "name: good\nresolution: low\n");
        WindowPreferences preferences = WindowPreferences.unsaved();
        List<String> refused = new ArrayList<>();
        try (Session session =
                EventThread.get(() -> new Session(Scenario.defaults().with("resolution=low", "threads=1")))) {
            EventThread.until("a scene", () -> session.scene().isPresent());
            WindowFiles files = EventThread.get(() -> {
                session.addListener(new MessageListener(refused::add));
                return new WindowFiles(null, session, null, preferences, plan -> {}, null);
            });
            for (Path file : List.of(picture, broken, empty)) {
                int before = refused.size();
                EventThread.run(() -> files.open(file));
                EventThread.until("the refusal of " + file, () -> refused.size() > before);
            }
            EventThread.run(() -> files.open(scenario));
            EventThread.until("the scenario", () -> session.scenario().name().equals("good"));
            assertThat(preferences.recent()).containsExactly(scenario);
        }
    }

    /** A number that is still being typed is taken when the dialog gets the focus. */
    @Test
    void whatIsChangedWhileTheFileIsChosenIsSaved() throws IOException {
        WindowHarness.assumeDisplay();
        Path saved = folder.resolve("saved.yaml");
        Path before = WindowPreferences.ofUser().folder();
        Scenario small = Scenario.defaults().with("resolution=low", "threads=1");
        try (Session session = EventThread.get(() -> new Session(small))) {
            EventThread.until("a scene", () -> session.scene().isPresent());
            List<String> done = new ArrayList<>();
            EventThread.run(() -> {
                WindowFiles files = new WindowFiles(null, session, null, WindowPreferences.unsaved(), plan -> {}, null);
                SwingUtilities.invokeLater(() -> files.saveScenario((scenario, name) -> done.add(name)));
            });
            EventThread.until("the dialog", () -> ShownDialogs.chooser().isPresent());
            EventThread.run(() -> {
                session.change("Depth", Assignment.read("test", "depth", "1.3"));
                ShownDialogs.chooser().orElseThrow().setSelectedFile(saved.toFile());
                ShownDialogs.chooser().orElseThrow().approveSelection();
            });
            EventThread.until("the file", () -> !done.isEmpty());
            assertThat(Scenario.read(saved).get(Breathing.DEPTH)).isEqualTo(1.3);
            assertThat(done).containsExactly(Scenario.read(saved).name());
        } finally {
            WindowPreferences.ofUser().setFolder(before);
        }
    }

    /** A file of the same name is replaced at the second time, and no other one written. */
    @Test
    void aNameThatTheFileReplacesIsSaidAndTheFileIsProposedAgain() {
        WindowHarness.assumeDisplay();
        Path before = WindowPreferences.ofUser().folder();
        Scenario named = Scenario.defaults().with("resolution=low", "threads=1", "name=Liver");
        try (Session session = EventThread.get(() -> new Session(named))) {
            EventThread.until("a scene", () -> session.scene().isPresent());
            List<String> said = new ArrayList<>();
            WindowFiles files = EventThread.get(() -> {
                session.addListener(new MessageListener(said::add));
                return new WindowFiles(null, session, null, WindowPreferences.unsaved(), plan -> {}, null);
            });
            assertThat(proposed(files, true)).isEqualTo("Liver.yaml");
            EventThread.until("the note", () -> !said.isEmpty());
            assertThat(said).singleElement().asString().endsWith("Its name is that of the file, mine.");
            assertThat(proposed(files, false)).isEqualTo("mine.yaml");
        } finally {
            EventThread.run(ShownDialogs::close);
            WindowPreferences.ofUser().setFolder(before);
        }
    }

    private String proposed(WindowFiles files, boolean saves) {
        EventThread.run(() -> SwingUtilities.invokeLater(() -> files.saveScenario((scenario, name) -> {})));
        EventThread.until("the dialog", () -> ShownDialogs.chooser().isPresent());
        return EventThread.get(() -> {
            JFileChooser chooser = ShownDialogs.chooser().orElseThrow();
            String name = chooser.getSelectedFile().getName();
            if (saves) {
                chooser.setSelectedFile(folder.resolve("mine.yaml").toFile());
                chooser.approveSelection();
            }
            return name;
        });
    }

    @Test
    void aScenarioIsSavedWithoutStepsAndChangesAndSaysSo() throws IOException {
        WindowHarness.assumeDisplay();
        Path saved = folder.resolve("saved.yaml");
        Path before = WindowPreferences.ofUser().folder();
        Scenario scheduled = Scenario.defaults()
                .with("resolution=low", "threads=1", "steps=900")
                .withChanges(List.of(ScheduledChange.parse("800:depth=0.5")));
        try (Session session = EventThread.get(() -> new Session(scheduled))) {
            EventThread.until("a scene", () -> session.scene().isPresent());
            List<String> said = new ArrayList<>();
            EventThread.run(() -> {
                session.addListener(new MessageListener(said::add));
                WindowFiles files = new WindowFiles(null, session, null, WindowPreferences.unsaved(), plan -> {}, null);
                SwingUtilities.invokeLater(() -> files.saveScenario((scenario, name) -> {}));
            });
            EventThread.until("the dialog", () -> ShownDialogs.chooser().isPresent());
            EventThread.run(() -> {
                ShownDialogs.chooser().orElseThrow().setSelectedFile(saved.toFile());
                ShownDialogs.chooser().orElseThrow().approveSelection();
            });
            EventThread.until("the note", () -> !said.isEmpty());
            assertThat(said)
                    .singleElement()
                    .asString()
                    .startsWith("Saved " + saved)
                    .contains("changes", "not saved");
            assertThat(Scenario.read(saved).steps()).isEqualTo(-1);
            assertThat(Scenario.read(saved).changes()).isEmpty();
            EventThread.run(() -> {
                session.change("Resolution", Assignment.read("test", "resolution", "medium"));
                assertThat(session.isScheduled())
                        .as("another scene, without them")
                        .isFalse();
                session.edits().undo();
                assertThat(session.isScheduled()).as("the scene that runs").isTrue();
            });
        } finally {
            WindowPreferences.ofUser().setFolder(before);
        }
    }
}
