package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.diaphragm.SheetQuality;

/** Scans of the virtual woman at inspiration; {@code phrenic bench bodies} measures more of them. */
class InspiredBodyTest {
    /** Coarser meshes than at low resolution: volumes and heights hardly depend on them. */
    private static final MeshBudget COARSE = new MeshBudget(8000);

    /** Edge length of voxels, mm: domes and lungs hardly depend on it. */
    private static final double VOXEL_MM = 3;

    /** A deep breath takes the domes down so far, mm, and what lies under them with them. */
    private static final double DOMES_MM = 48;

    private static final Thorax WOMAN = VirtualThorax.ofPreset("adult-female", COARSE);
    private static final InspiredBody INSPIRED = new InspiredBody(
            () -> WOMAN,
            COARSE,
            ImportedBodies.shares(List.of(BodyCut.WHOLE, BodyCut.HALF_INSPIRED, BodyCut.INSPIRED_ABDOMEN)));

    private static double lungMl(Thorax body) {
        return body.structuresOf(StructureKind.LUNG).stream()
                .mapToDouble(s -> MeshMeasure.signedVolumeMl(s.mesh()))
                .sum();
    }

    private static double topOfLiver(Thorax body) {
        return body.find("liver").map(Structure::mesh).orElseThrow().bounds()[5];
    }

    /** A deep breath takes the domes down by 48 mm and the lungs take in 1.8 l; half way lies between. */
    @Test
    void lungsFillAndTheLiverGoesDown() {
        Thorax half = INSPIRED.at(0.5);
        Thorax full = INSPIRED.at(1);
        assertThat(lungMl(full) - lungMl(WOMAN)).isBetween(1500.0, 2100.0);
        assertThat((lungMl(half) - lungMl(WOMAN)) / (lungMl(full) - lungMl(WOMAN)))
                .isBetween(0.4, 0.6);
        assertThat(topOfLiver(WOMAN) - topOfLiver(full)).isBetween(30.0, 50.0);
        assertThat(topOfLiver(WOMAN) - topOfLiver(half)).isBetween(15.0, 25.0);
        Map<String, TriangleMesh> resting =
                WOMAN.structuresAndOrgans().stream().collect(Collectors.toMap(Structure::name, Structure::mesh));
        assertThat(full.structures()).allSatisfy(s -> assertThat(s.mesh().triangles())
                .isEqualTo(resting.get(s.name()).triangles()));
        assertThat(resting.get("spleen").bounds()[5]
                        - full.find("spleen").orElseThrow().mesh().bounds()[5])
                .as("descent of the spleen, which lies under the left dome, mm")
                .isCloseTo(DOMES_MM, within(DOMES_MM / 10));
    }

    /**
     * The import takes a full inspiration back in a scan that ends 25 mm above the liver, so that the spine above is a
     * template's: the diaphragm stands where that of the body does. The lower borders of the lungs rise less than in a
     * breath of the model, so that the lungs stay larger by up to 15 %. Organs that the turned ribs leave no room yield
     * to the diaphragm.
     */
    @Test
    void anImportBringsTheDomesBackToEndExpiration(@TempDir Path folder) {
        BodyCase woman = new BodyCase("woman", "virtual", 1, () -> WOMAN);
        double top = WOMAN.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh().bounds()[5];
        List<BodyCut> cuts = List.of(BodyCut.INSPIRED_ABDOMEN);
        Supplier<Thorax> template = () -> VirtualThorax.ofPreset("adult-male", COARSE);
        for (BodyCase scan : ImportedBodies.cuts(woman, cuts, INSPIRED, template, folder, VOXEL_MM)) {
            Thorax imported = scan.thorax().get();
            assertThat(imported.structuresOf(StructureKind.DIAPHRAGM)
                            .get(0)
                            .mesh()
                            .bounds()[5])
                    .as(scan.name())
                    .isCloseTo(top, within(2.0));
            assertThat(lungMl(imported) / lungMl(WOMAN)).as(scan.name()).isBetween(1.0, 1.15);
            assertThat(SheetQuality.of(imported).orElseThrow().value("organs_through_maximum_mm"))
                    .as("%s, mm", scan.name())
                    .isLessThan(1);
            assertThat(scan.original().orElseThrow().get()).isSameAs(WOMAN);
        }
    }
}
