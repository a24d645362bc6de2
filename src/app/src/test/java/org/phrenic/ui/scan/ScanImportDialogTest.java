package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScanImportDialogTest {
    @Test
    void aFolderMayHaveBlanksInItsName() {
        assertThat(ScanImportDialog.folder(" my scans/body 1 ")).contains(Path.of("my scans/body 1"));
    }

    /** A body that is there already is not proposed to be replaced. */
    @Test
    void theProposedFolderDoesNotExist(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("case.nii.gz");
        assertThat(ScanImportDialog.proposedFolder(scan)).isEqualTo(folder.resolve("case-body"));
        Files.createDirectory(folder.resolve("case-body"));
        assertThat(ScanImportDialog.proposedFolder(scan)).isEqualTo(folder.resolve("case-body-2"));
    }

    @Test
    void aDiscMayBeAScan() {
        Path root = Path.of("").toAbsolutePath().getRoot();
        assertThat(ScanImportDialog.proposedFolder(root).getFileName()).hasToString("scan-body");
    }

    @Test
    void aBodyCannotBeWrittenIntoAFile(@TempDir Path folder) throws IOException {
        Path file = Files.createFile(folder.resolve("scan.nii"));
        assertThat(ScanImportDialog.isWritable(folder.resolve("new/body"))).isTrue();
        assertThat(ScanImportDialog.isWritable(file.resolve("body"))).isFalse();
    }

    /** Without a name the body would be written into the working directory. */
    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "/", "a\0b"})
    void aTextThatNamesNoFolderIsNone(String text) {
        assertThat(ScanImportDialog.folder(text)).isEmpty();
    }
}
