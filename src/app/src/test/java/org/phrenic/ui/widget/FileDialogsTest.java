package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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

    /** A name with a character that no file system has stands for one that the encoding of the system lacks. */
    @Test
    void aNameThatTheSystemCannotWriteIsRefusedInOneSentence() {
        List<String> refused = new ArrayList<>();
        assertThat(FileDialogs.path(new File("scan\0.yaml"), refused::add)).isEmpty();
        assertThat(refused)
                .singleElement()
                .asString()
                .startsWith("found a name that this system cannot write, expected one in the encoding of file names");
        assertThat(FileDialogs.path(new File("scan.yaml"), refused::add)).contains(Path.of("scan.yaml"));
    }
}
