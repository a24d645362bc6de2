package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;

/** A window whose first body cannot be loaded. */
class WindowFirstBodyTest {
    @TempDir
    private Path folder;

    @BeforeAll
    static void display() {
        WindowHarness.assumeDisplay();
    }

    @Test
    void theViewSaysWhyThereIsNoBodyAndAPictureOfItIsRefused() {
        Session session = EventThread.get(() -> new Session(Scenario.defaults().with("anatomy=" + folder)));
        EventThread.until("the end of loading", () -> !session.live().isLoading());
        PhrenicWindow window = EventThread.get(() -> new PhrenicWindow(WindowPreferences.unsaved(), session));
        try {
            EventThread.until(
                    "whether pictures can be drawn",
                    () -> window.view().graphicsInfo().isPresent()
                            || window.view().isUnavailable());
            assumeThat(window.view().isUnavailable()).isFalse();
            EventThread.until("the reason", () -> window.view().placeholder().contains(folder.toString()));
            assertThat(window.banner().message()).contains(folder.toString());
            Path picture = folder.resolve("none.png");
            EventThread.run(() -> window.files().savePicture(picture));
            EventThread.until(
                    "why no picture is written", () -> window.banner().message().contains(picture.toString()));
        } finally {
            EventThread.run(window::close);
        }
    }
}
