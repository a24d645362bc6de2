package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
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
}
