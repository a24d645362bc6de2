package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.label.GeometryOverride;

class ImportPipelineTest {
    private static final double SPACING_MM = 3;
    private static final int MARGIN = 3;

    @TempDir
    Path folder;

    /** The virtual woman's ribs 7 to 12, vertebrae and liver, and beside them a speck with the label of rib 1. */
    @Test
    void aSpeckIsNotTakenForTheFirstRib() throws IOException {
        Thorax woman = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        double[] box = PatientBody.merged(woman.structures().stream().filter(s -> s.kind() == StructureKind.RIB))
                .orElseThrow()
                .bounds();
        int[] size = new int[3];
        double[] toVoxel = new double[12];
        double[] toMm = new double[12];
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = (int) ((box[3 + axis] - box[axis]) / SPACING_MM) + 2 * MARGIN;
            toMm[5 * axis] = SPACING_MM;
            toMm[4 * axis + 3] = box[axis] - MARGIN * SPACING_MM;
            toVoxel[5 * axis] = 1 / SPACING_MM;
            toVoxel[4 * axis + 3] = -toMm[4 * axis + 3] / SPACING_MM;
        }
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        MeshVoxelizer voxels = new MeshVoxelizer(size[0], size[1], size[2], toVoxel, labels);
        StringBuilder table = new StringBuilder("label,structure\n1,rib_1_L\n");
        int label = 1;
        for (Structure s : woman.structures()) {
            boolean rib = s.kind() == StructureKind.RIB && s.level() >= 7;
            boolean vertebra = s.kind() == StructureKind.VERTEBRA && s.level() >= 7;
            if (rib || vertebra || s.kind() == StructureKind.LIVER) {
                voxels.fill(s.mesh(), ++label);
                table.append(label).append(',').append(s.name()).append('\n');
            }
        }
        for (int v = 0; v < 64; v++) {
            labels[10 + v % 4 + size[0] * (10 + v / 4 % 4 + size[1] * (10 + v / 16))] = 1;
        }
        Path file = folder.resolve("scan.nii.gz");
        NiftiWriter.write(file, LabelGrid.of(size[0], size[1], size[2], labels, toMm));
        Path names = Files.writeString(folder.resolve("labels.csv"), table);
        PatientBody body = ImportPipeline.run(
                        ImportRequest.of(
                                file,
                                "scan",
                                Optional.of(names.toString()),
                                VirtualThorax.ofPreset("adult-male", Resolution.LOW)),
                        (count, total, structure) -> {})
                .body();
        assertThat(body.notes()).anyMatch(note -> note.startsWith("left out, too small") && note.contains("rib_01_L"));
        PatientStructure rib = body.structure("rib_01_L").orElseThrow();
        assertThat(rib.source()).isEqualTo(PatientStructure.Source.VIRTUAL);
        assertThat(rib.structure().mesh().centre()[2]).isGreaterThan(box[2] + 0.75 * (box[5] - box[2]));
    }

    /** An ellipsoid in a volume that is cropped to it, and one from which 20 mm at an end are missing. */
    @Test
    void aVolumeThatIsCroppedToItsLabelsCutsOffNothing() throws IOException {
        Path table = Files.writeString(folder.resolve("labels.csv"), "label,structure\n1,liver\n");
        for (int missing : new int[] {0, 5}) {
            int[] size = {40, 30, 25 - missing};
            byte[] labels = new byte[size[0] * size[1] * size[2]];
            for (int v = 0; v < labels.length; v++) {
                double x = (v % size[0] - 19.5) / 20;
                double y = (v / size[0] % size[1] - 14.5) / 15;
                double z = (v / (size[0] * size[1]) - 12) / 12.5;
                labels[v] = (byte) (x * x + y * y + z * z < 1 ? 1 : 0);
            }
            Path file = folder.resolve("liver.nii.gz");
            double[] toMm = {4, 0, 0, -80, 0, 4, 0, -60, 0, 0, 4, 900};
            NiftiWriter.write(file, LabelGrid.of(size[0], size[1], size[2], labels, toMm));
            ImportResult result = ImportPipeline.run(
                    new ImportRequest(
                            file,
                            "liver",
                            Optional.of(table.toString()),
                            Optional.empty(),
                            GeometryOverride.NONE,
                            Optional.empty(),
                            Optional.empty()),
                    (count, total, structure) -> {});
            PatientStructure liver = result.body().structure("liver").orElseThrow();
            assertThat(liver.scan().orElseThrow().cutAt()).isEqualTo(missing == 0 ? "" : "S");
            double[] box = liver.structure().mesh().bounds();
            assertThat(box[0]).isCloseTo(-82, within(3.0));
            assertThat(box[4]).isCloseTo(58, within(3.0));
            assertThat(box[2]).isCloseTo(898, within(3.0));
            assertThat(result.grid().orElseThrow().slices()).as("the file's").isEqualTo(size[2]);
        }
    }

    /** Labels that rise and fall by one from voxel to voxel, as between 0 and 10 in an image that is made larger. */
    @Test
    void labelsThatWereInterpolatedAreRefusedWithAnyTable() {
        byte[] labels = new byte[60 * 10 * 10];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (10 - Math.abs(10 - v % 20));
        }
        Path file = folder.resolve("scan.nii.gz");
        NiftiWriter.write(file, LabelGrid.of(60, 10, 10, labels, new double[] {3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0}));
        ImportRequest request = ImportRequest.of(
                file, "scan", Optional.of("amos"), VirtualThorax.ofPreset("adult-male", Resolution.LOW));
        assertThatThrownBy(() -> ImportPipeline.run(request, (count, total, structure) -> {}))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("scan.nii.gz: found layers of numbers between those of two structures");
    }
}
