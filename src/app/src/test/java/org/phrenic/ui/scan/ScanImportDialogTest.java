package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.patient.ScanSamples;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.window.WindowHarness;

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

    /** A red outline alone tells neither the reason nor a screen reader. */
    @Test
    void whatCannotBeImportedIsToldBesideItsMark(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        EventThread.run(() -> {
            JPanel content = new ScanImportDialog(scan, labels).content();
            requireRefusal(content, "Axes", "LLS", "one each of L or R, P or A, S or I, such as LPS");
            requireRefusal(content, "Voxel, mm", "2", "three sizes in mm, such as 1.75, 1.75, 1.25");
            requireRefusal(content, "Thorax folder", scan + "/body", "a folder that can be written");
        });
    }

    private static void requireRefusal(JPanel content, String name, String text, String expected) {
        JTextField field = WindowHarness.find(content, JTextField.class, name).orElseThrow();
        String before = field.getText();
        String told = name + ": found '" + text + "', expected " + expected + ".";
        field.setText(text);
        assertThat(field.getAccessibleContext().getAccessibleDescription()).isEqualTo(told);
        assertThat(WindowHarness.find(content, JLabel.class, told)).isPresent();
        field.setText(before);
        assertThat(field.getAccessibleContext().getAccessibleDescription()).isEqualTo(field.getToolTipText());
        assertThat(WindowHarness.find(content, JLabel.class, told)).isEmpty();
    }

    /** Without a name the body would be written into the working directory. */
    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "/", "a\0b"})
    void aTextThatNamesNoFolderIsNone(String text) {
        assertThat(ScanImportDialog.folder(text)).isEmpty();
    }
}
