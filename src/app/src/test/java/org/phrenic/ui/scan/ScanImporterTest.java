package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.awt.Component;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JTextField;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.OutputException;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.ScanSamples;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.window.WindowHarness;

/** Which body an import opens. */
class ScanImporterTest {
    private static final Scenario SMALL = WindowHarness.COARSE_SHEET.with("threads=1");

    private final List<Path> opened = new ArrayList<>();

    @TempDir
    private Path folder;

    @BeforeAll
    static void display() {
        WindowHarness.assumeDisplay();
    }

    private static final class Shown implements ScanImporter.Display {
        @Override
        public void showProgress(String stage, double share) {}

        @Override
        public void rehearse() {}

        @Override
        public boolean isAttemptUnderWay() {
            return false;
        }
    }

    private static ImportResult result() {
        PatientBody body = new PatientBody(
                "scanned",
                List.of(
                        ImportSummaryDialogTest.structure(StructureKind.DIAPHRAGM, "diaphragm"),
                        ImportSummaryDialogTest.structure(StructureKind.RIB, "rib_07_R")),
                List.of("sternum"),
                List.of());
        return new ImportResult(
                "scan.mha", Optional.empty(), body, Optional.empty(), Optional.empty(), Optional.empty(), List.of());
    }

    /** Ends an import beside a session, and presses Rehearse in its summary. */
    private void rehearse(Session session) {
        EventThread.run(() -> {
            new ScanImporter(null, session, new Shown(), opened::add, read -> {}).finish(folder, result());
            WindowHarness.find(
                            WindowHarness.dialog("import.summary").orElseThrow().getRootPane(),
                            JButton.class,
                            "Rehearse")
                    .orElseThrow()
                    .doClick();
        });
    }

    /** Its loading may have been cancelled, and another body opened, since the import. */
    @Test
    void theBodyOfTheSummaryIsRehearsedThoughAnotherIsPresent() {
        try (Session session = EventThread.get(() -> new Session(SMALL))) {
            rehearse(session);
            assertThat(opened).containsExactly(folder, folder);
        }
    }

    @Test
    void theBodyOfTheSummaryIsNotLoadedAnewWhereItIsPresent() {
        try (Session session = EventThread.get(() -> new Session(SMALL.with("anatomy=" + folder)))) {
            rehearse(session);
            assertThat(opened).containsExactly(folder);
        }
    }

    /** A table of labels that need no table would fail an import on a full disc. */
    @Test
    void onlyEditedLabelsTakeATemporaryFolder() throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        ScanImportDialog.Choice choice =
                new ScanImportDialog.Choice(labels, GeometryOverride.NONE, Optional.empty(), folder.resolve("body"));
        CancellableProgress cancelled = new CancellableProgress((stage, share) -> {});
        cancelled.cancel();
        Path noFolder = Files.createFile(folder.resolve("file"));
        assertThat(ScanImporter.build(scan, choice, cancelled, noFolder)).isEmpty();
        labels.assignByNumber(labels.tools().iterator().next());
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> ScanImporter.build(scan, choice, cancelled, noFolder))
                .withMessageContaining("writing into folder " + noFolder + " failed: ");
    }

    /** A scan whose labels have names, so that they are guessed. */
    private Path namedScan() throws IOException {
        String header = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: "
                + ScanSamples.COLUMNS + " " + ScanSamples.ROWS + " " + ScanSamples.SLICES
                + "\nspace directions: (4,0,0) (0,4,0) (0,0,4)\nspace origin: (0,0,0)\nencoding: raw\n"
                + "Segment0_Name:=lungs\nSegment0_LabelValue:=1\nSegment1_Name:=liver\nSegment1_LabelValue:=5\n\n";
        Path scan = Files.writeString(folder.resolve("scan.nrrd"), header, StandardCharsets.US_ASCII);
        return Files.write(scan, ScanSamples.voxels(), StandardOpenOption.APPEND);
    }

    private ImportResult importInto(Path body, ScanLabels labels, Path scan) throws IOException {
        CancellableProgress progress = new CancellableProgress((stage, share) -> {});
        ScanImportDialog.Choice choice =
                new ScanImportDialog.Choice(labels, GeometryOverride.NONE, Optional.empty(), body);
        return ScanImporter.build(scan, choice, progress, folder).orElseThrow();
    }

    /** Nothing tells whose a table is: it may be another program's, or written by hand for many labels. */
    @Test
    void aTableOfLabelsIsReplacedByAnEditedOneAloneAndOtherwiseStaysWithANote() throws IOException {
        Path scan = namedScan();
        Thorax template = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        ScanLabels edited = ScanLabels.read(scan, template);
        edited.setValueAt("spleen", 1, ScanLabels.STRUCTURE_COLUMN);
        Path body = folder.resolve("mueller");
        Path table = body.resolve("labels.csv");
        assertThat(importInto(body, ScanLabels.read(scan, template), scan)
                        .body()
                        .notes())
                .noneMatch(note -> note.startsWith("labels.csv"));
        Files.writeString(table, "label,structure\n");
        for (int again = 0; again < 2; again++) {
            assertThat(importInto(body, ScanLabels.read(scan, template), scan)
                            .body()
                            .notes())
                    .contains("labels.csv: was in the folder and stays as it is; the body is of the proposed"
                            + " structures");
            assertThat(table).hasContent("label,structure");
        }
        assertThat(body.resolve("import.json")).content().contains("labels.csv: was in the folder");
        assertThat(importInto(body, edited, scan).body().notes()).noneMatch(note -> note.startsWith("labels.csv"));
        assertThat(table).content().contains("lungs", "spleen");
    }

    private static JTextField folderField(Component at) {
        return WindowHarness.find(at, JTextField.class, "Thorax folder").orElseThrow();
    }

    @Test
    void theAnswersForAnImportThatHasToWaitAreShownAgain() throws IOException {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        ScanLabels labels = ScanLabels.read(scan, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        try (Session session = EventThread.get(() -> new Session(SMALL))) {
            List<String> told = new ArrayList<>();
            EventThread.run(() -> {
                session.addListener(new MessageListener(told::add));
                ScanImporter importer = new ScanImporter(null, session, new Shown(), opened::add, read -> {});
                importer.begin(scan);
                ScanImportDialog answered = new ScanImportDialog(scan, labels);
                folderField(answered.content()).setText("another body");
                importer.run(scan, answered, null);
                importer.cancel();
                importer.cancel();
                assertThat(told)
                        .containsExactly(
                                "An import is running; cancel it first.",
                                "The import is cancelled; nothing is written.");
                JDialog shown = WindowHarness.dialog("import").orElseThrow();
                assertThat(folderField(shown.getRootPane()).getText()).isEqualTo("another body");
                shown.dispose();
            });
        }
    }
}
