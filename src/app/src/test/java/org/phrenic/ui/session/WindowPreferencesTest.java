package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WindowPreferencesTest {
    @TempDir
    private Path folder;

    /** A stored name that is no path here, as after a session with another encoding, hinders no other. */
    @Test
    void aStoredNameThatIsNoPathIsPassedOver() throws IOException {
        Map<String, String> stored = new HashMap<>();
        WindowPreferences preferences = new WindowPreferences(stored::getOrDefault, stored::put);
        Path file = Files.writeString(folder.resolve("scene.yaml"), "");
        preferences.addRecent(file);
        assertThat(preferences.recent()).containsExactly(file);
        stored.put("recent", "\0odd\n" + file);
        stored.put("folder", "\0odd");
        assertThat(preferences.recent()).containsExactly(file);
        assertThat(preferences.folder()).isDirectory();
    }
}
