package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Hashes;
import org.phrenic.file.InputBytes;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.label.GeometryOverride;

/** A folder of bones without a diaphragm, named as other programs name them, in cm and RAS. */
class MeshFolderTest {
    @TempDir
    private Path folder;

    private static ImportResult imported(Path folder) {
        return imported(folder, Optional.empty());
    }

    private static ImportResult imported(Path folder, Optional<ImportRequest.Completion> completion) {
        return ImportPipeline.run(
                new ImportRequest(
                        folder,
                        "bones",
                        Optional.empty(),
                        Optional.empty(),
                        GeometryOverride.NONE,
                        completion,
                        Optional.empty()),
                (count, total, structure) -> {});
    }

    /** Names of the files and of the structures in them. */
    private static final Map<String, String> NAMES = Map.of(
            "rib_left_7", "rib_07_L", "rib_07_R", "rib_07_R", "vertebrae_T7", "vertebra_T07", "T12", "vertebra_T12");

    private void writeBones(Thorax body) {
        NAMES.forEach((file, structure) -> VtpWriter.write(
                folder.resolve(file + ".vtp"),
                rasCentimetres(body.find(structure).orElseThrow().mesh()),
                Map.of()));
    }

    @Test
    void bonesInAnotherFrameAndUnitAreBroughtToLpsAndMillimetres() {
        Thorax body = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        writeBones(body);
        VtpWriter.write(
                folder.resolve("liver lobe ligament.vtp"),
                rasCentimetres(body.find("liver").orElseThrow().mesh()),
                Map.of());
        ImportResult result = imported(folder);
        assertThat(result.body().structures())
                .extracting(s -> s.structure().name())
                .containsExactlyInAnyOrderElementsOf(NAMES.values());
        assertThat(result.body().notes()).contains("liver lobe ligament.vtp: left out, its name is no structure's");
        assertThat(result.body().missing()).contains("diaphragm", "rib_08_L").doesNotContain("rib_07_L");
        double[] rib = result.body()
                .structure("rib_07_L")
                .orElseThrow()
                .structure()
                .mesh()
                .bounds();
        double[] expected = body.find("rib_07_L").orElseThrow().mesh().bounds();
        assertThat(rib).containsExactly(expected, within(0.01));
        assertThat(result.report()).containsKey("folder").doesNotContainKey("voxels");
    }

    private static TriangleMesh rasCentimetres(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] *= i % 3 == 2 ? 0.1 : -0.1;
        }
        return mesh.withPositions(p);
    }

    /** Among the last files of the import is a folder, which no file can replace. */
    @Test
    void anImportThatStopsHalfWayIsReadAsNoBodyUntilItIsRepeated() throws IOException {
        writeBones(VirtualThorax.ofPreset("adult-female", Resolution.LOW));
        ImportResult result = imported(folder);
        Path out = folder.resolve("body");
        result.write(out);
        Map<String, String> whole = contents(out);
        Path last = out.resolve("vertebra_T12.vtp");
        Files.delete(last);
        Files.createDirectory(last);
        assertThatThrownBy(() -> result.write(out)).isInstanceOf(OutputException.class);
        assertThatThrownBy(() -> ThoraxFolder.loadPart(out, Optional::of))
                .isInstanceOf(BadInputException.class)
                .hasMessage(out + ": found the files of an import that did not end, expected a whole body;"
                        + " the scan has to be imported again");
        Files.delete(last);
        result.write(out);
        assertThat(contents(out)).isEqualTo(whole);
        assertThat(ThoraxFolder.loadPart(out, Optional::of).structures()).hasSize(NAMES.size());
    }

    private static Map<String, String> contents(Path folder) {
        return InputBytes.list(folder).stream()
                .collect(Collectors.toMap(file -> file.getFileName().toString(), Hashes::sha256));
    }

    private void write(String name, TriangleMesh mesh) {
        VtpWriter.write(folder.resolve(name + ".vtp"), mesh, Map.of());
    }

    private void writeFourBones(Thorax body) {
        for (String bone : List.of("rib_07_L", "rib_07_R", "vertebra_T07", "vertebra_T12")) {
            write(bone, body.find(bone).orElseThrow().mesh());
        }
    }

    /** The mesh at half its height, on top of the other half. */
    private static TriangleMesh half(TriangleMesh mesh, boolean upper) {
        double[] p = mesh.positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] = 0.5 * (p[i] + mesh.bounds()[upper ? 5 : 2]);
        }
        return mesh.withPositions(p);
    }

    /**
     * Of a structure that may have parts, each file is a part; those of an organ are one, as labels of a volume are.
     */
    @Test
    void filesOfOneStructureAreAllInTheBodyThatIsWritten() {
        Thorax body = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        writeFourBones(body);
        TriangleMesh lung = body.find("lung_L").orElseThrow().mesh();
        write("lung_lower_lobe_left", half(lung, false));
        write("lung_upper_lobe_left", half(lung, true));
        write("heart_atrium_left", half(lung, true));
        write("heart_myocardium", half(lung, false));
        ImportResult result = imported(folder);
        Path out = folder.resolve("patient");
        result.write(out);
        Thorax written = ThoraxFolder.loadPart(out, Optional::of);
        assertThat(written.structures())
                .extracting(Structure::name)
                .filteredOn(name -> name.startsWith("lung") || name.startsWith("heart"))
                .containsExactlyInAnyOrder("lung_L", "lung_L_2", "heart");
        double volume = MeshMeasure.signedVolume(lung);
        for (String stem : List.of("lung", "heart")) {
            assertThat(written.structures().stream()
                            .filter(s -> s.name().startsWith(stem))
                            .mapToDouble(s -> MeshMeasure.signedVolume(s.mesh()))
                            .sum())
                    .as(stem)
                    .isCloseTo(volume, withinPercentage(0.1));
        }
        assertThat(result.body().notes())
                .contains("lung_L: its 2 files are kept as lung_L, lung_L_2", "heart: its 2 files are taken together");
    }

    /**
     * Names of aids that begin as those of structures do, the name that an import gives to one, and one in an index.
     */
    @Test
    void aidsOfAPlanAreLeftOutAsThoseOfAVolumeAre() throws IOException {
        Thorax body = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        writeFourBones(body);
        TriangleMesh liver = body.find("liver").orElseThrow().mesh();
        for (String aid : List.of("Ring_2cm", "other_planning-ptv_60_ring", "skin_PRV05", "Lung_L_Ring")) {
            write(aid, liver);
        }
        write("lung_L_tumor", liver);
        write("lung_R_effusion", liver);
        write("skin_torso", liver);
        ImportResult result = imported(folder);
        assertThat(result.body().structures())
                .extracting(s -> s.structure().name())
                .containsExactlyInAnyOrder(
                        "rib_07_L", "rib_07_R", "vertebra_T07", "vertebra_T12", "lesion_lung_tumor_L", "skin_torso");
        assertThat(result.body().notes())
                .contains("margins and aids of a radiotherapy plan, left out: other_planning-lung_ring_L,"
                        + " other_planning-ring_2cm, other_planning-ptv_60_ring, other_planning-skin_prv05")
                .contains("lung_R_effusion.vtp: left out, its name is no structure's");
        Files.writeString(
                folder.resolve("thorax.yaml"),
                "axes: LPS\nunits: mm\nstructures:\n  rib_07_L: rib_07_L.vtp\n  Ring_2cm: Ring_2cm.vtp\n"
                        + "  other_liver_and_spleen: lung_L_tumor.vtp\n  sternum_wire: lung_R_effusion.vtp\n");
        assertThat(imported(folder).body().structures())
                .extracting(s -> s.structure().name())
                .containsExactlyInAnyOrder("rib_07_L", "other_liver_and_spleen");
        assertThat(imported(folder).body().notes())
                .contains("lung_R_effusion.vtp: left out, its name is no structure's");
    }

    /** A folder that an import has made is imported again. */
    @Test
    void whatAFolderStatesNotToBeInTheScanStaysSo() throws IOException {
        writeFourBones(VirtualThorax.ofPreset("adult-female", Resolution.LOW));
        String raised = "end-expiration (domes raised by 41 mm)";
        Files.writeString(
                folder.resolve("thorax.yaml"),
                "axes: LPS\nunits: mm\nnot_in_scan:\n- rib_07_L\n- part of the lungs\n- " + raised + "\n");
        ImportResult result = imported(folder);
        assertThat(result.body().structure("rib_07_L").orElseThrow().source())
                .isEqualTo(PatientStructure.Source.VIRTUAL);
        assertThat(result.body().structure("rib_07_R").orElseThrow().source()).isEqualTo(PatientStructure.Source.SCAN);
        Path out = folder.resolve("patient");
        result.write(out);
        assertThat(ThoraxFolder.loadPart(out, Optional::of).notInScan())
                .containsExactlyInAnyOrder("rib_07_L", "part of the lungs", raised);
    }

    /** Two vertebrae in mm are shorter than what is taken for a part of a body in mm, and are read as cm. */
    @Test
    void meshesOfNoPersonsSizeAreRefusedWithTheFileThatStatesTheirUnits() {
        Thorax body = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        for (String bone : List.of("vertebra_T07", "vertebra_T08")) {
            write(bone, body.find(bone).orElseThrow().mesh());
        }
        ImportRequest.Completion completion = new ImportRequest.Completion(body, false);
        assertThatThrownBy(() -> imported(folder, Optional.of(completion)))
                .isInstanceOf(BadInputException.class)
                .hasMessageMatching(".*: found a body .* times as large as adult-female, expected 0.5 to 1.7 times;"
                        + " are units and axes right\\? a thorax.yaml beside the meshes states them");
    }

    @Test
    void aFolderWithoutANamedMeshIsRefused() {
        assertThatThrownBy(() -> imported(folder))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("no mesh has the name of a structure");
    }
}
