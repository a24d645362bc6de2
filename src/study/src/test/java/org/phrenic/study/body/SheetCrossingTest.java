package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Surface;

/**
 * Small octahedra as organs at known places of the virtual man's diaphragm; its right dome is highest at z = 115 mm.
 */
class SheetCrossingTest {
    private static final Diaphragm SHEET =
            Diaphragm.withTrefoilTendon(VirtualThorax.ofPreset("adult-male", Resolution.LOW)
                    .find("diaphragm")
                    .orElseThrow()
                    .mesh());

    private static OrganCrossing crossing(String name, StructureKind kind, double x, double y, double z) {
        double r = 2;
        double[] p = {x + r, y, z, x - r, y, z, x, y + r, z, x, y - r, z, x, y, z + r, x, y, z - r};
        int[] t = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
        return crossing(name, kind, new TriangleMesh(p, t));
    }

    /** A tetrahedron with one corner far from its base. */
    private static OrganCrossing spike(String name, StructureKind kind, double[] tip, double baseZ) {
        double x = tip[0];
        double y = tip[1];
        double[] p = {x, y, tip[2], x, y + 6, baseZ, x + 8, y - 6, baseZ, x - 10, y - 6, baseZ};
        return crossing(name, kind, new TriangleMesh(p, new int[] {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}));
    }

    private static OrganCrossing crossing(String name, StructureKind kind, TriangleMesh organ) {
        List<Surface> surfaces =
                List.of(surface("diaphragm", StructureKind.DIAPHRAGM, SHEET.sheet()), surface(name, kind, organ));
        return new SheetCrossing(SHEET).measure(surfaces, List.of(SHEET.sheet(), organ));
    }

    private static Surface surface(String name, StructureKind kind, TriangleMesh mesh) {
        return new Surface(name, kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    @Test
    void organsOnTheirOwnSideDoNotCount() {
        assertThat(crossing("liver", StructureKind.LIVER, -68, -16, 70)).isEqualTo(OrganCrossing.NONE);
        assertThat(crossing("lung_R", StructureKind.LUNG, -68, -16, 160)).isEqualTo(OrganCrossing.NONE);
        assertThat(crossing("spleen", StructureKind.ORGAN, 70, 20, 50)).isEqualTo(OrganCrossing.NONE);
        assertThat(crossing("heart", StructureKind.ORGAN, 6, -45, 130)).isEqualTo(OrganCrossing.NONE);
    }

    /** An organ wholly on the wrong side passes nothing from its own middle, one that reaches through the dome does. */
    @Test
    void organThatReachesThroughTheDomeCounts() {
        assertThat(crossing("liver", StructureKind.LIVER, -68, -16, 160)).isEqualTo(OrganCrossing.NONE);
        OrganCrossing crossing = spike("liver", StructureKind.LIVER, new double[] {-68, -16, 130}, 20);
        assertThat(crossing.liverVertices()).isEqualTo(1);
        assertThat(crossing.lungVertices()).isZero();
        assertThat(crossing.deepest()).isEqualTo("liver");
        // The abdominal face lies 2 to 3 mm below the highest point of the dome at 116 mm.
        assertThat(crossing.deepestMm()).isCloseTo(15.5, within(2.5));
    }

    @Test
    void verticesAreCountedByTheKindOfTheirOrgan() {
        OrganCrossing lung = spike("lung_R", StructureKind.LUNG, new double[] {-68, -16, 100}, 190);
        assertThat(lung).isEqualTo(new OrganCrossing(1, 0, 0, lung.deepestMm(), "lung_R"));
        assertThat(lung.deepestMm()).isCloseTo(15.5, within(2.5));
        OrganCrossing spleen = spike("spleen", StructureKind.ORGAN, new double[] {-68, -16, 130}, 20);
        assertThat(spleen).isEqualTo(new OrganCrossing(0, 0, 1, spleen.deepestMm(), "spleen"));
    }

    /** Three tenths of the way from the abdominal to the thoracic face, nearest to the face of its own side. */
    @Test
    void aVertexBetweenTheFacesIsOnTheWrongSide() {
        TriangleMesh sheet = SHEET.sheet();
        int low = IntStream.range(0, sheet.vertexCount())
                .filter(v -> !SHEET.isThoracic(v))
                .boxed()
                .max(Comparator.comparingDouble(sheet::z))
                .orElseThrow();
        double[] below = {sheet.x(low), sheet.y(low), sheet.z(low)};
        double[] above = IntStream.range(0, sheet.vertexCount())
                .filter(SHEET::isThoracic)
                .mapToObj(v -> new double[] {sheet.x(v), sheet.y(v), sheet.z(v)})
                .min(Comparator.comparingDouble(p -> Vectors.distance(p, below)))
                .orElseThrow();
        double thickness = Vectors.distance(above, below);
        double[] tip = new double[3];
        Arrays.setAll(tip, i -> below[i] + 0.3 * (above[i] - below[i]));
        OrganCrossing crossing = spike("liver", StructureKind.LIVER, tip, 20);
        assertThat(crossing.deepest()).isEqualTo("liver");
        assertThat(crossing.deepestMm()).isCloseTo(0.3 * thickness, within(0.05 * thickness));
        assertThat(crossing.vertices()).as("less than the limit").isZero();
    }

    /** The liver's lower edge in front of the belly is below the costal margin, not through the wall. */
    @Test
    void beyondTheBorderThereAreNoSides() {
        assertThat(crossing("liver", StructureKind.LIVER, -90, -110, -60)).isEqualTo(OrganCrossing.NONE);
    }
}
