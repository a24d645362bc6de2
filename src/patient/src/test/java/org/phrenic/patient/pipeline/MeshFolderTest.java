package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Hashes;
import org.phrenic.file.InputBytes;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.VtpWriter;
import org.phrenic.patient.label.GeometryOverride;

/** A folder of bones without a diaphragm, named as other programs name them, in cm and RAS. */
class MeshFolderTest {
    @TempDir
    private Path folder;

    private static ImportResult imported(Path folder) {
        return ImportPipeline.run(
                new ImportRequest(
                        folder,
                        "bones",
                        Optional.empty(),
                        Optional.empty(),
                        GeometryOverride.NONE,
                        Optional.empty(),
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
        Thorax body = VirtualThorax.generate(VirtualThoraxParameters.preset("adult-female"), Resolution.LOW);
        writeBones(body);
        ImportResult result = imported(folder);
        assertThat(result.body().structures())
                .extracting(s -> s.structure().name())
                .containsExactlyInAnyOrderElementsOf(NAMES.values());
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
        writeBones(VirtualThorax.generate(VirtualThoraxParameters.preset("adult-female"), Resolution.LOW));
        ImportResult result = imported(folder);
        Path out = folder.resolve("body");
        result.write(out);
        Map<String, String> whole = contents(out);
        Path last = out.resolve("vertebra_T12.vtp");
        Files.delete(last);
        Files.createDirectory(last);
        assertThatThrownBy(() -> result.write(out)).isInstanceOf(OutputException.class);
        assertThatThrownBy(() -> ThoraxFolder.loadPart(out, name -> Optional.empty()))
                .isInstanceOf(BadInputException.class)
                .hasMessage(out + ": found the files of an import that did not end, expected a whole body;"
                        + " the scan has to be imported again");
        Files.delete(last);
        result.write(out);
        assertThat(contents(out)).isEqualTo(whole);
        assertThat(ThoraxFolder.loadPart(out, name -> Optional.empty()).structures())
                .hasSize(NAMES.size());
    }

    private static Map<String, String> contents(Path folder) {
        return InputBytes.list(folder).stream()
                .collect(Collectors.toMap(file -> file.getFileName().toString(), Hashes::sha256));
    }

    @Test
    void aFolderWithoutANamedMeshIsRefused() {
        assertThatThrownBy(() -> imported(folder))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("no mesh has the name of a structure");
    }
}
