package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.patient.ScanSamples;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.window.ShownDialogs;
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

    /** The name of a DICOM file is often its number, which has dots. */
    @ParameterizedTest
    @CsvSource({
        "1.2.276.0.7230010.3.dcm, 1.2.276.0.7230010.3",
        "1.2.276.0.7230010.3, 1.2.276.0.7230010.3",
        "case.v2.NII.GZ, case.v2",
        "case.seg.nrrd, case",
        "case.nii.gz#2, case",
        ".nii, .nii",
        "masks.d, masks.d"
    })
    void theFolderIsCalledAsTheScanWithoutItsEnding(String scan, String stem, @TempDir Path folder) {
        assertThat(ScanImportDialog.proposedFolder(folder.resolve(scan)).getFileName())
                .hasToString(stem + "-body");
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

    @Test
    void theHeadingTellsWhereTheNamesAreFrom(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"lungs\": 1, \"liver\": 5}}");
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        EventThread.run(
                () -> assertThat(new ScanImportDialog(scan, labels).content().getComponent(0))
                        .isInstanceOfSatisfying(JLabel.class, label -> assertThat(label.getText())
                                .startsWith("scan.mha, ")
                                .endsWith("; dataset.json names the labels")));
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
            requireRefusal(
                    content, "Voxel, mm", "2", "three sizes in mm, each from 0.1 to 50, such as 1.75, 1.75, 1.25");
            requireRefusal(content, "Thorax folder", scan + "/body", "a folder that can be written");
        });
    }

    /** A button that is off alone does not say what to do. */
    @Test
    void withoutAStructureTheDialogSaysWhereToChooseOne(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        Object guessed = labels.getValueAt(0, ScanLabels.STRUCTURE_COLUMN);
        String advice = "Choose a structure for at least one label: click in the column Structure.";
        EventThread.run(() -> {
            ScanImportDialog dialog = new ScanImportDialog(scan, labels);
            JPanel content = dialog.content();
            for (int row = 0; row < labels.getRowCount(); row++) {
                labels.setValueAt(ScanLabels.NONE, row, ScanLabels.STRUCTURE_COLUMN);
            }
            assertThat(dialog.start().isEnabled()).isFalse();
            assertThat(WindowHarness.find(content, JLabel.class, advice)).isPresent();
            labels.setValueAt("liver", 0, ScanLabels.STRUCTURE_COLUMN);
            assertThat(dialog.start().isEnabled()).isTrue();
            assertThat(WindowHarness.find(content, JLabel.class, advice)).isEmpty();
            JComboBox<?> numbers = WindowHarness.find(content, JComboBox.class, "Label numbers as in")
                    .orElseThrow();
            assertThat(numbers.getSelectedItem()).isEqualTo("(none)");
            numbers.setSelectedIndex(1);
            assertThat(labels.isEdited()).isTrue();
            numbers.setSelectedIndex(0);
            assertThat(labels.isEdited()).as("the file's own structures").isFalse();
            labels.setValueAt(labels.getValueAt(0, ScanLabels.STRUCTURE_COLUMN), 0, ScanLabels.STRUCTURE_COLUMN);
            assertThat(labels.isEdited()).as("a cell that was looked at").isFalse();
            assertThat(labels.getValueAt(0, ScanLabels.STRUCTURE_COLUMN)).isEqualTo(guessed);
        });
    }

    /** The list is opened to look, and the dialog is shown again after an import that failed. */
    @Test
    void aChoiceThatIsMadeAgainLeavesTheStructuresThatWereEdited(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        EventThread.run(() -> {
            ScanImportDialog dialog = new ScanImportDialog(scan, labels);
            labels.setValueAt("spleen", 0, ScanLabels.STRUCTURE_COLUMN);
            numbers(dialog).setSelectedIndex(0);
            assertThat(labels.getValueAt(0, ScanLabels.STRUCTURE_COLUMN)).isEqualTo("spleen");
            numbers(dialog).setSelectedIndex(1);
            Object tool = numbers(dialog).getSelectedItem();
            assertThat(numbers(dialog).getSelectedItem()).as("shown again").isEqualTo(tool);
            assertThat(tool).isNotEqualTo("(none)");
        });
    }

    private static JComboBox<?> numbers(ScanImportDialog dialog) {
        return WindowHarness.find(dialog.content(), JComboBox.class, "Label numbers as in")
                .orElseThrow();
    }

    /** A body may be meshes alone, and a table of labels lies where a scan does. */
    @Test
    void whatAnImportWritesOverIsNamed(@TempDir Path folder) throws IOException {
        assertThat(ScanImportDialog.replaced(folder.resolve("new"), true)).isEmpty();
        Files.createFile(folder.resolve("scan.nii.gz"));
        Files.createFile(folder.resolve("labels.csv"));
        assertThat(ScanImportDialog.replaced(folder, false)).isEmpty();
        assertThat(ScanImportDialog.replaced(folder, true)).containsExactly("labels.csv");
        Path mesh = Files.createFile(folder.resolve("liver.VTP"));
        assertThat(ScanImportDialog.replaced(folder, true)).containsExactly("the body", "labels.csv");
        Files.delete(mesh);
        Files.createFile(folder.resolve("thorax.yaml"));
        assertThat(ScanImportDialog.replaced(folder, false)).containsExactly("the body");
    }

    /** The table is written only if it was edited, which the button tells before it is pressed. */
    @Test
    void theButtonNamesWhatIsReplaced(@TempDir Path folder) throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        Path table = Files.createDirectory(folder.resolve("tables"));
        Files.createFile(table.resolve("labels.csv"));
        Path body = Files.createDirectory(folder.resolve("mueller"));
        Files.createFile(body.resolve("rib_05_R.vtp"));
        Files.createFile(body.resolve("labels.csv"));
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        EventThread.run(() -> {
            ScanImportDialog dialog = new ScanImportDialog(scan, labels);
            assertThat(dialog.start().getText()).isEqualTo("Import");
            JTextField to = WindowHarness.find(dialog.content(), JTextField.class, "Thorax folder")
                    .orElseThrow();
            to.setText(body.toString());
            assertThat(dialog.start().getText()).isEqualTo("Import and replace the body");
            to.setText(table.toString());
            assertThat(dialog.start().getText()).isEqualTo("Import");
            labels.setValueAt("liver", 0, ScanLabels.STRUCTURE_COLUMN);
            assertThat(dialog.start().getText()).isEqualTo("Import and replace labels.csv");
            to.setText(body.toString());
            assertThat(dialog.start().getText()).isEqualTo("Import and replace the body and labels.csv");
        });
    }

    /** A report in the chosen folder stays as it is: it is no file of an import. */
    @Test
    void aFolderWithAReportIsChosenWithoutAQuestion(@TempDir Path folder) throws IOException {
        WindowHarness.assumeDisplay();
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        Path chosen = Files.createDirectory(folder.resolve("chosen"));
        Files.createFile(chosen.resolve("report.json"));
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        Path before = WindowPreferences.ofUser().folder();
        JPanel content = EventThread.get(() -> new ScanImportDialog(scan, labels).content());
        JTextField field =
                WindowHarness.find(content, JTextField.class, "Thorax folder").orElseThrow();
        JButton choose = WindowHarness.find(content, JButton.class, "Choose").orElseThrow();
        try {
            EventThread.run(() -> SwingUtilities.invokeLater(choose::doClick));
            EventThread.until("the dialog", () -> ShownDialogs.chooser().isPresent());
            EventThread.run(() -> {
                JFileChooser chooser = ShownDialogs.chooser().orElseThrow();
                chooser.setSelectedFile(chosen.toFile());
                chooser.approveSelection();
            });
            EventThread.until(
                    "the folder or a question",
                    () -> field.getText().equals(chosen.toString())
                            || ShownDialogs.question().isPresent());
            assertThat(EventThread.get(ShownDialogs::question)).isEmpty();
        } finally {
            EventThread.run(ShownDialogs::close);
            WindowPreferences.ofUser().setFolder(before);
        }
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
