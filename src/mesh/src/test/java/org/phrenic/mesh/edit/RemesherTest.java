package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceComparison;

class RemesherTest {
    @ParameterizedTest
    @ValueSource(ints = {50, 300, 642, 3000})
    void aSphereStaysASphereOfTheSameVolumeWithEvenTriangles(int vertices) {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        TriangleMesh remeshed = Remesher.toVertexCount(sphere, vertices);
        holdsTheSame(sphere, remeshed, vertices, 0.002);
        for (int v = 0; v < remeshed.vertexCount(); v++) {
            double r = Math.sqrt(Math.pow(remeshed.x(v), 2) + Math.pow(remeshed.y(v), 2) + Math.pow(remeshed.z(v), 2));
            // A polyhedron of 50 vertices with the sphere's volume stands out by about 5 % at its
            // corners.
            assertThat(r).isBetween(9.7, 10.6);
        }
        if (vertices >= sphere.vertexCount()) {
            liesOn(sphere, remeshed);
        }
    }

    @Test
    void aTorusKeepsItsHole() {
        TriangleMesh torus = Shapes.torus(20, 6, 60, 30);
        holdsTheSame(torus, Remesher.toVertexCount(torus, 400), 400, 0.002);
        TriangleMesh refined = Remesher.toVertexCount(torus, 5000);
        holdsTheSame(torus, refined, 5000, 0.002);
        liesOn(torus, refined);
    }

    @Test
    void aRefinedBoxKeepsItsEdges() {
        TriangleMesh box = Shapes.box(40, 30, 20);
        TriangleMesh remeshed = Remesher.toVertexCount(box, 2000);
        holdsTheSame(box, remeshed, 2000, 1e-6);
        assertThat(MeshMeasure.area(remeshed)).isCloseTo(MeshMeasure.area(box), within(1e-3));
    }

    @Test
    void noVertexOfAThinSheetCrossesToItsOtherFace() {
        TriangleMesh sheet = Shapes.box(100, 80, 2);
        TriangleMesh remeshed = Remesher.toVertexCount(Remesher.toVertexCount(sheet, 3000), 700);
        holdsTheSame(sheet, remeshed, 700, 0.002);
        double[] normals = MeshMeasure.triangleNormals(remeshed);
        int[] t = remeshed.triangles();
        for (int i = 0; i < remeshed.triangleCount(); i++) {
            double z = (remeshed.z(t[3 * i]) + remeshed.z(t[3 * i + 1]) + remeshed.z(t[3 * i + 2])) / 3;
            // A triangle across the rim, 2 mm high and 5 mm wide, leans to 0.93; what is flatter lies in a face.
            if (Math.abs(normals[3 * i + 2]) > 0.97) {
                assertThat(normals[3 * i + 2] > 0).isEqualTo(z > 1);
            }
        }
    }

    @Test
    void anOpenSheetKeepsItsCornersAndItsRim() {
        TriangleMesh sheet = Shapes.sheet(40, 30, 30, 20);
        for (int vertices : new int[] {200, 1500}) {
            TriangleMesh remeshed = Remesher.toVertexCount(sheet, vertices);
            assertThat(remeshed.vertexCount()).isEqualTo(vertices);
            assertThat(MeshMeasure.area(remeshed)).isCloseTo(1200, within(1e-6));
            assertThat(remeshed.bounds()).containsExactly(new double[] {0, 0, 0, 40, 30, 0}, within(1e-9));
            assertThat(new MeshTopology(remeshed).boundaryLoops()).hasSize(1);
        }
    }

    @Test
    void anOpenTubeKeepsItsTwoLoops() {
        TriangleMesh tube = Shapes.tube(10, 40, 40, 20);
        TriangleMesh remeshed = Remesher.toVertexCount(tube, 400);
        assertThat(remeshed.vertexCount()).isEqualTo(400);
        assertThat(new MeshTopology(remeshed).boundaryLoops()).hasSize(2);
        assertThat(remeshed.bounds()[2]).isCloseTo(0, within(1e-9));
        assertThat(remeshed.bounds()[5]).isCloseTo(40, within(1e-9));
    }

    @Test
    void theSameInputGivesTheSameBits() {
        TriangleMesh torus = Shapes.torus(20, 6, 60, 30);
        TriangleMesh first = Remesher.toVertexCount(torus, 900);
        TriangleMesh second = Remesher.toVertexCount(torus, 900);
        assertThat(second.positions()).containsExactly(first.positions());
        assertThat(second.triangles()).containsExactly(first.triangles());
    }

    @Test
    void aSurfaceThatIsNotManifoldIsCutOpenNotRefused() {
        TriangleMesh sheet = Shapes.sheet(10, 10, 6, 6);
        double[] p = Arrays.copyOf(sheet.positions(), sheet.positions().length + 3);
        p[p.length - 3] = 5;
        p[p.length - 2] = 5;
        p[p.length - 1] = 5;
        int[] t = Arrays.copyOf(sheet.triangles(), sheet.triangles().length + 3);
        t[t.length - 3] = 14;
        t[t.length - 2] = 20;
        t[t.length - 1] = 36;
        TriangleMesh remeshed = Remesher.toVertexCount(new TriangleMesh(p, t), 200);
        assertThat(new MeshTopology(remeshed).isManifold()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"6500, 0.02", "8700, 0.02", "11359, 0.02"})
    void aRealDiaphragmKeepsItsOpeningsAndVolume(int vertices, double volume) {
        TriangleMesh both = MeshRepair.repair(TestPly.thorax("diaphragm"), 1e-3).mesh();
        TriangleMesh sheet = ConnectedComponents.of(both).stream()
                .filter(m -> new MeshTopology(m).isClosed())
                .findFirst()
                .orElseThrow();
        assertThat(sheet.vertexCount()).isEqualTo(2642);
        holdsTheSame(sheet, Remesher.toVertexCount(sheet, vertices), vertices, volume);
    }

    @ParameterizedTest
    @ValueSource(strings = {"01_L", "04_R", "06_L", "06_R", "07_L", "10_R"})
    void aRealCartilageBecomesACoarseClosedTube(String name) {
        TriangleMesh cartilage = MeshRepair.repair(TestPly.thorax("costal_cartilage_" + name), 1e-3)
                .mesh();
        holdsTheSame(cartilage, Remesher.toVertexCount(cartilage, 120), 120, 0.08);
    }

    @Test
    void fewerThanFourVerticesAreRefused() {
        assertThatThrownBy(() -> Remesher.toVertexCount(Shapes.box(1, 1, 1), 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("3 vertices");
    }

    /** A surface with as many vertices or more has them on the original, within a fiftieth of an edge. */
    private static void liesOn(TriangleMesh before, TriangleMesh after) {
        double edge =
                MeshMeasure.edgeLengthSummary(after, new MeshTopology(after)).mean();
        assertThat(SurfaceComparison.of(after, before).aToB().perVertex().maximum())
                .isLessThan(0.02 * edge);
    }

    /**
     * The promise of the class for a closed surface: count, topology, volume, and triangles fit for a mass-spring
     * model.
     */
    private static void holdsTheSame(TriangleMesh before, TriangleMesh after, int vertices, double volume) {
        MeshTopology topology = new MeshTopology(after);
        assertThat(after.vertexCount()).isEqualTo(vertices);
        assertThat(topology.isClosed()).isTrue();
        assertThat(topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(new MeshTopology(before).eulerCharacteristic());
        assertThat(MeshMeasure.signedVolume(after) / MeshMeasure.signedVolume(before))
                .isCloseTo(1, within(volume));
        double[] angles = MeshMeasure.smallestAngles(after);
        Arrays.sort(angles);
        assertThat(angles[angles.length / 100]).isGreaterThan(20);
        MeshMeasure.EdgeLengths lengths = MeshMeasure.edgeLengthSummary(after, topology);
        assertThat(lengths.minimum()).isGreaterThan(0.3 * lengths.mean());
    }
}
