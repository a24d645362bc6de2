package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.SelfIntersections;

class VirtualThoraxMeshTest {
    private static final double BUDGET_TOLERANCE = 0.01;
    private static final double LEAST_EDGE_MM = 1.5;

    @ParameterizedTest
    @CsvSource({
        "adult-male, LOW", "adult-male, MEDIUM", "adult-male, HIGH",
        "adult-female, LOW", "adult-female, MEDIUM", "adult-female, HIGH"
    })
    void whatSpringsMoveHasTheVerticesOfTheResolution(String preset, Resolution resolution) {
        Thorax thorax = VirtualThorax.ofPreset(preset, resolution);
        int sheet = vertices(thorax, StructureKind.DIAPHRAGM);
        int lungs = vertices(thorax, StructureKind.LUNG);
        int sternum = vertices(thorax, StructureKind.STERNUM, StructureKind.COSTAL_CARTILAGE);
        double tolerance = BUDGET_TOLERANCE * resolution.vertices();
        assertThat((double) sheet + lungs + sternum).isCloseTo(resolution.vertices(), within(tolerance));
        assertThat((double) sheet).isCloseTo(resolution.diaphragmVertices(), within(tolerance));
        assertThat((double) lungs).isCloseTo(resolution.budget().lungVertices(), within(tolerance));
    }

    @ParameterizedTest
    @CsvSource({"adult-male, LOW", "adult-male, HIGH", "adult-female, MEDIUM"})
    void everySurfaceIsClosedAndLooksOutward(String preset, Resolution resolution) {
        for (Structure structure : VirtualThorax.ofPreset(preset, resolution).structures()) {
            SurfaceChecks surface = new SurfaceChecks(structure.mesh());
            assertThat(surface.isClosedAndOriented()).as(structure.name()).isTrue();
            assertThat(surface.volumeMl()).as(structure.name()).isPositive();
            assertThat(structure.mesh().positions()).as(structure.name()).doesNotContain(Double.NaN);
            if (structure.kind() != StructureKind.VERTEBRA) {
                assertThat(surface.eulerCharacteristic()).as(structure.name()).isEqualTo(2);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"adult-male, LOW", "adult-male, HIGH", "adult-female, MEDIUM"})
    void noLungPassesThroughItself(String preset, Resolution resolution) {
        Thorax thorax = VirtualThorax.ofPreset(preset, resolution);
        assertThat(thorax.structuresOf(StructureKind.LUNG))
                .allSatisfy(lung -> assertThat(SelfIntersections.count(lung.mesh()))
                        .as(lung.name())
                        .isZero());
    }

    @Test
    void structuresAreNamedAsTheFilesOfAThoraxFolder() {
        Thorax thorax = VirtualThorax.ofPreset("adult-male", Resolution.MEDIUM);
        assertThat(thorax.structures()).extracting(Structure::name).doesNotHaveDuplicates();
        assertThat(thorax.structures())
                .extracting(Structure::name)
                .contains("rib_01_R", "rib_12_L", "costal_cartilage_10_L", "sternum_xiphoid", "vertebra_T01")
                .contains("vertebra_L03", "disc_T1_T2", "disc_T12_L1", "disc_L2_L3", "lung_R", "lung_L")
                .contains("liver", "diaphragm", "skin_torso")
                .doesNotContain("costal_cartilage_11_R");
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void trianglesThatSpringsActOnAreNoNeedles(String preset) {
        Thorax thorax = VirtualThorax.ofPreset(preset, Resolution.MEDIUM);
        for (String name : new String[] {"diaphragm", "lung_R", "lung_L"}) {
            SurfaceChecks surface = SurfaceChecks.of(thorax, name);
            int n = surface.mesh.triangleCount();
            long needles = IntStream.range(0, n)
                    .filter(t -> surface.smallestAngleDeg(t) < 20)
                    .count();
            assertThat(needles).as(name).isLessThan(n / 200);
        }
    }

    /** The shortest edge sets the time step: a wave of stretch must not cross it within one (Courant). */
    @ParameterizedTest
    @CsvSource({"adult-male, MEDIUM", "adult-male, HIGH", "adult-female, MEDIUM", "adult-female, HIGH"})
    void noEdgeOfTheDiaphragmIsShort(String preset, Resolution resolution) {
        SurfaceChecks sheet = SurfaceChecks.of(VirtualThorax.ofPreset(preset, resolution), "diaphragm");
        assertThat(sheet.shortestEdge()).isGreaterThan(LEAST_EDGE_MM);
    }

    @Test
    void facesOfTheDiaphragmArePartnersOneThicknessApart() {
        VirtualThoraxParameters parameters = VirtualThoraxParameters.preset("adult-male");
        SurfaceChecks sheet = SurfaceChecks.of(VirtualThorax.ofPreset("adult-male", Resolution.MEDIUM), "diaphragm");
        int half = sheet.mesh.vertexCount() / 2;
        double thinnest = Double.POSITIVE_INFINITY;
        double thickest = 0;
        for (int v = 0; v < half; v++) {
            double apart = Vectors.distance(sheet.vertex(v), sheet.vertex(v + half));
            thinnest = Math.min(thinnest, apart);
            thickest = Math.max(thickest, apart);
        }
        assertThat(thinnest).isCloseTo(parameters.diaphragm().tendonMm(), within(1e-9));
        assertThat(thickest).isCloseTo(parameters.diaphragm().muscleMm(), within(1e-9));
    }

    @Test
    void theSameMeasuresGiveTheSameBits() {
        Thorax one = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        Thorax two = VirtualThorax.generate(VirtualThoraxParameters.preset("adult-male"), Resolution.LOW);
        for (int i = 0; i < one.structures().size(); i++) {
            Structure a = one.structures().get(i);
            Structure b = two.structures().get(i);
            assertThat(b.name()).isEqualTo(a.name());
            assertThat(b.mesh().positions())
                    .as(a.name())
                    .containsExactly(a.mesh().positions());
            assertThat(b.mesh().triangles())
                    .as(a.name())
                    .containsExactly(a.mesh().triangles());
        }
    }

    private static int vertices(Thorax thorax, StructureKind... kinds) {
        return thorax.structures().stream()
                .filter(s -> List.of(kinds).contains(s.kind()))
                .mapToInt(s -> s.mesh().vertexCount())
                .sum();
    }
}
