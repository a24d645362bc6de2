package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.plaf.basic.BasicFileChooserUI;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.ui.session.EventThread;

/** What a dialog proposes is what its field shows, which a press on Save takes. */
class FileDialogsTest {
    @Test
    void aNewFolderIsProposed(@TempDir Path folder) {
        String shown = EventThread.get(() -> {
            Theme.install(false);
            JFileChooser chooser = new JFileChooser(folder.toFile());
            FileDialogs.propose(chooser, "rehearsal 2026-11-25 16.21");
            return ((BasicFileChooserUI) chooser.getUI()).getFileName();
        });
        assertThat(Path.of(shown)).isEqualTo(folder.resolve("rehearsal 2026-11-25 16.21"));
    }
}
