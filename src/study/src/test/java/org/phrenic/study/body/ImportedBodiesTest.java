package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

class ImportedBodiesTest {
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    @TempDir
    private Path folder;

    /** The scan of a body shows the bones of that body alone, whatever lay there before. */
    @Test
    void meshesOfAnEarlierScanAreNoneOfALaterOne() throws IOException {
        Path meshes = ImportedBodies.folders(folder, "man").get(1);
        Files.createDirectories(meshes);
        Files.writeString(meshes.resolve("clavicle_R.stl"), "of another");
        Files.writeString(meshes.resolve("notes.txt"), "of the user");
        ImportedBodies.scanned("man", MAN, BodyCut.BONE_MESHES, MAN, folder, BodyCut.VOXEL_MM);
        assertThat(meshes.resolve("clavicle_R.stl")).doesNotExist();
        assertThat(meshes.resolve("rib_05_R.vtp")).exists();
        assertThat(meshes.resolve("notes.txt")).hasContent("of the user");
    }

    @Test
    void aScanIsNamedAfterItsFileItsPhaseOrItsFolder() throws IOException {
        Path patient = Files.createDirectory(folder.resolve("patient.nii"));
        assertThat(List.of(
                        name(patient.resolve(".")),
                        name(patient.resolve("..").resolve("patient.nii")),
                        name(folder.resolve("a.nii.gz")),
                        name(folder.resolve("b.NRRD")),
                        name(folder.resolve("c.nii.gz#2"))))
                .containsExactly("patient.nii", "patient.nii", "a", "b", "c-2");
        BodyCase body = new BodyCase(patient.resolve(".").toString(), "as it is", 1, () -> MAN);
        assertThat(ImportedBodies.cuts(body, List.of(BodyCut.WHOLE), () -> MAN, folder))
                .extracting(BodyCase::name)
                .containsExactly("patient.nii-whole");
    }

    private String name(Path scan) {
        return ImportedBodies.scan(scan, () -> MAN, folder).name();
    }
}
