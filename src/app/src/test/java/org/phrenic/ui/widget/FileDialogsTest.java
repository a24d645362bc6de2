package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFileChooser;
import javax.swing.plaf.basic.BasicFileChooserUI;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.ui.access.AttemptReportWriter;
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

    /** A folder may hold a plan and a scenario of one's own, which would be lost. */
    @Test
    void eachFileThatIsWrittenOverIsAskedFor(@TempDir Path folder) throws IOException {
        assertThat(FileDialogs.replaced(folder.toFile(), AttemptReportWriter.FILES))
                .isEmpty();
        for (String name : List.of("plan.yaml", "notes.txt", "scenario.yaml")) {
            Files.createFile(folder.resolve(name));
        }
        assertThat(FileDialogs.replaced(folder.toFile(), AttemptReportWriter.FILES))
                .contains("Replace plan.yaml, scenario.yaml in " + folder.getFileName() + "?");
        assertThat(FileDialogs.replaced(folder.resolve("new").toFile(), AttemptReportWriter.FILES))
                .isEmpty();
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
