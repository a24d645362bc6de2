package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScanImportDialogTest {
    @Test
    void aFolderMayHaveBlanksInItsName() {
        assertThat(ScanImportDialog.folder(" my scans/body 1 ")).contains(Path.of("my scans/body 1"));
    }

    /** Without a name the body would be written into the working directory. */
    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "/", "a\0b"})
    void aTextThatNamesNoFolderIsNone(String text) {
        assertThat(ScanImportDialog.folder(text)).isEmpty();
    }
}
