package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.prefs.AbstractPreferences;
import java.util.prefs.BackingStoreException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WindowPreferencesTest {
    @TempDir
    private Path folder;

    /** A node of a platform that stores nothing, as in a home folder that cannot be written. */
    private static final class Unstored extends AbstractPreferences {
        private final Exception refusal;

        Unstored(Exception refusal) {
            super(null, "");
            this.refusal = refusal;
        }

        @Override
        public void flush() throws BackingStoreException {
            if (refusal instanceof SecurityException denied) {
                throw denied;
            }
            throw new BackingStoreException(refusal.getMessage());
        }

        @Override
        public void sync() throws BackingStoreException {
            flush();
        }

        @Override
        protected void putSpi(String key, String value) {}

        @Override
        protected String getSpi(String key) {
            return null;
        }

        @Override
        protected void removeSpi(String key) {}

        @Override
        protected void removeNodeSpi() {}

        @Override
        protected String[] keysSpi() {
            return new String[0];
        }

        @Override
        protected String[] childrenNamesSpi() {
            return new String[0];
        }

        @Override
        protected AbstractPreferences childSpi(String name) {
            return this;
        }

        @Override
        protected void syncSpi() {}

        @Override
        protected void flushSpi() {}
    }

    /** Else they are lost without a word. */
    @Test
    void aPlatformThatStoresNothingIsFoundAtTheStart() {
        for (Exception refusal : List.of(
                new IOException("Couldn't get file lock."), new SecurityException("Lock file access denied."))) {
            String reason = refusal.getMessage().replace(".", "");
            assertThat(WindowPreferences.problem(new Unstored(refusal)))
                    .contains("What the window remembers cannot be stored and lasts until it is closed (" + reason
                            + ").");
        }
    }

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

    /** Whether it is there is found out when it is opened. */
    @Test
    void aFileOnADriveThatIsAwayStaysListed() {
        Map<String, String> stored = new HashMap<>();
        WindowPreferences preferences = new WindowPreferences(stored::getOrDefault, stored::put);
        Path away = folder.resolve("away").resolve("scene.yaml");
        preferences.addRecent(away);
        assertThat(preferences.recent()).containsExactly(away);
    }
}
