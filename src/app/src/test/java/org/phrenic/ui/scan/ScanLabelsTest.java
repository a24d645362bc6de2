package org.phrenic.ui.scan;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.ScanSamples;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.LabelTable;

/** What the dialog of an import proposes for the geometry of a volume. */
class ScanLabelsTest {
    private static final Thorax USUAL = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    @TempDir
    private Path folder;

    /** Two lungs, the right one the larger, and a liver below it; slices are 4 mm apart in this direction. */
    private Path scan(String up) throws IOException {
        byte[] labels = ScanSamples.voxels();
        for (int v = 0; v < labels.length; v++) {
            boolean right = v % ScanSamples.COLUMNS < 30;
            labels[v] = (byte) (labels[v] == ScanSamples.LIVER ? 3 : labels[v] == 0 ? 0 : right ? 1 : 2);
        }
        String header = "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: "
                + ScanSamples.COLUMNS + " " + ScanSamples.ROWS + " " + ScanSamples.SLICES
                + "\nspace directions: (4,0,0) (0,4,0) (0,0," + up + ")\nencoding: raw\nspace origin: (0,0,0)\n"
                + "Segment0_LabelValue:=1\nSegment0_Name:=right lung\n"
                + "Segment1_LabelValue:=2\nSegment1_Name:=left lung\n"
                + "Segment2_LabelValue:=3\nSegment2_Name:=liver\n\n";
        Path file = folder.resolve("scan.seg.nrrd");
        Files.write(file, header.getBytes(StandardCharsets.US_ASCII));
        return Files.write(file, labels, StandardOpenOption.APPEND);
    }

    @Test
    void axesAndSpacingOfTheFileAreProposedAndKept() throws IOException {
        ScanLabels labels = ScanLabels.read(scan("4"), USUAL);
        assertThat(labels.axes()).isEqualTo("LPS");
        assertThat(labels.axesProblem()).isEmpty();
        assertThat(labels.spacing()).isEqualTo("4, 4, 4");
        assertThat(labels.geometry(" lps", labels.spacing())).isEqualTo(GeometryOverride.NONE);
        assertThat(labels.geometry("RAS", "4, 4, 5"))
                .isEqualTo(new GeometryOverride(Optional.of("RAS"), Optional.of("4, 4, 5")));
    }

    /** The import refuses such a volume with any table. */
    @Test
    void labelsThatWereInterpolatedAreToldBeforeTheImport() throws IOException {
        byte[] labels = new byte[60 * 10 * 10];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (10 - Math.abs(10 - v % 20));
        }
        Path file = folder.resolve("waves.nii.gz");
        NiftiWriter.write(file, LabelGrid.of(60, 10, 10, labels, new double[] {3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0}));
        assertThat(ScanLabels.read(file, USUAL).refusal())
                .hasValueSatisfying(why -> assertThat(why).contains("were interpolated linearly"));
        ScanSamples.writeMha(folder.resolve("scan.mha"));
        assertThat(ScanLabels.read(folder.resolve("scan.mha"), USUAL).refusal()).isEmpty();
    }

    /** A data set beside the scan names the labels. */
    @Test
    void namesBesideTheScanAreProposed() throws IOException {
        Path file = folder.resolve("case.mha");
        ScanSamples.writeMha(file);
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"lungs\": 1, \"liver\": 5}}");
        ScanLabels labels = ScanLabels.read(file, USUAL);
        assertThat(labels.getValueAt(1, 1)).isEqualTo("liver");
        assertThat(labels.getValueAt(0, ScanLabels.STRUCTURE_COLUMN)).isEqualTo("lungs");
        assertThat(labels.origin()).containsExactly("dataset.json names the labels");
    }

    /** A table with such a name is refused by the import, after the dialog with all its answers is gone. */
    @Test
    void aNameThatIsNoStructureIsTold() throws IOException {
        ScanLabels labels = ScanLabels.read(scan("4"), USUAL);
        assertThat(labels.unknown()).isEmpty();
        labels.setValueAt("liver, left", 2, ScanLabels.STRUCTURE_COLUMN);
        assertThat(labels.unknown()).contains("liver, left");
        labels.setValueAt(" liver ", 2, ScanLabels.STRUCTURE_COLUMN);
        assertThat(labels.unknown()).isEmpty();
        labels.setValueAt(ScanLabels.NONE, 2, ScanLabels.STRUCTURE_COLUMN);
        assertThat(labels.unknown()).isEmpty();
    }

    /** A liver above the lungs: other axes are proposed, and whoever keeps those of the file states them. */
    @Test
    void axesThatTheStructuresContradictAreReplaced() throws IOException {
        ScanLabels labels = ScanLabels.read(scan("-4"), USUAL);
        assertThat(labels.axes()).isEqualTo("LPS");
        assertThat(labels.axesProblem())
                .hasValueSatisfying(problem -> assertThat(problem).contains("run to LPS", "the file states LPI"));
        assertThat(labels.geometry(labels.axes(), labels.spacing()).axes()).contains("LPS");
        assertThat(labels.geometry("LPI", labels.spacing()).axes()).contains("LPI");
    }

    @Test
    void aStructureWithACommaIsReadAgainAsItWasTyped() throws IOException {
        Path scan = scan("4");
        ScanLabels labels = ScanLabels.read(scan, USUAL);
        labels.setValueAt("other_cyst, left", 2, ScanLabels.STRUCTURE_COLUMN);
        assertThat(labels.unknown()).isEmpty();
        Path table = labels.writeIfEdited(folder.resolve("labels.csv")).orElseThrow();
        assertThat(LabelTable.read(table, LabelVolumeFiles.read(scan)).structures())
                .containsEntry(3, "other_cyst, left")
                .hasSize(3);
    }
}
