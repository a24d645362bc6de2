package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;
import org.phrenic.file.BadInputException;
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

    @Test
    void bonesInAnotherFrameAndUnitAreBroughtToLpsAndMillimetres() {
        Thorax body = VirtualThorax.generate(VirtualThoraxParameters.preset("adult-female"), Resolution.LOW);
        Map<String, String> names = Map.of(
                "rib_left_7",
                "rib_07_L",
                "rib_07_R",
                "rib_07_R",
                "vertebrae_T7",
                "vertebra_T07",
                "T12",
                "vertebra_T12");
        names.forEach((file, structure) -> VtpWriter.write(
                folder.resolve(file + ".vtp"),
                rasCentimetres(body.find(structure).orElseThrow().mesh()),
                Map.of()));
        ImportResult result = imported(folder);
        assertThat(result.body().structures())
                .extracting(s -> s.structure().name())
                .containsExactlyInAnyOrderElementsOf(names.values());
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

    @Test
    void aFolderWithoutANamedMeshIsRefused() {
        assertThatThrownBy(() -> imported(folder))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("no mesh has the name of a structure");
    }
}
