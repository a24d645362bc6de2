package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.Test;

/** What becomes of files that are dropped on the window. */
class FileDropHandlerTest {
    private final List<Path> opened = new ArrayList<>();
    private final List<String> refused = new ArrayList<>();

    private boolean drop(File... files) {
        TransferSupport dropped = dropped(new DroppedFiles(List.of(files)));
        FileDropHandler handler = handler();
        assertThat(handler.canImport(dropped)).isTrue();
        return handler.importData(dropped);
    }

    private FileDropHandler handler() {
        return new FileDropHandler(opened::add, refused::add);
    }

    private static TransferSupport dropped(Transferable what) {
        return new TransferSupport(new JPanel(), what);
    }

    @Test
    void textIsNoFile() {
        assertThat(handler().canImport(dropped(new StringSelection("scan.yaml"))))
                .isFalse();
    }

    @Test
    void oneFileIsOpened() {
        assertThat(drop(new File("scan.yaml"))).isTrue();
        assertThat(opened).containsExactly(Path.of("scan.yaml"));
        assertThat(refused).isEmpty();
    }

    @Test
    void severalFilesAndANameThatTheSystemCannotWriteAreRefusedInOneSentence() {
        assertThat(drop(new File("a.yaml"), new File("b.yaml"))).isFalse();
        assertThat(drop(new File("scan\0.yaml"))).isFalse();
        assertThat(opened).isEmpty();
        assertThat(refused).hasSize(2).first().asString().contains("found 2 files");
        assertThat(refused.get(1)).startsWith("found a name that this system cannot write, expected one");
    }
}
