package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class MeshMeasureTest {
    private static final double ROUNDING = 1e-9;

    @Property(tries = 50, seed = "1")
    void aBoxHasTheAreaAndVolumeOfABoxWhereverItStands(
            @ForAll @DoubleRange(min = 0.1, max = 100) double a,
            @ForAll @DoubleRange(min = 0.1, max = 100) double b,
            @ForAll @DoubleRange(min = 0.1, max = 100) double c,
            @ForAll @DoubleRange(min = -2000, max = 2000) double away) {
        TriangleMesh box = Shapes.moved(Shapes.box(a, b, c), away, -away, away / 2);
        assertThat(MeshMeasure.area(box)).isCloseTo(2 * (a * b + b * c + c * a), within(1e-6));
        assertThat(MeshMeasure.signedVolume(box)).isCloseTo(a * b * c, within(1e-6));
    }

    /** That of a tetrahedron is the mean of its corners; that of two boxes is weighted by 1000 and 6000 mm3. */
    @Test
    void theCentreOfMassIsWeightedByVolume() {
        TriangleMesh tetrahedron = new TriangleMesh(
                new double[] {0, 0, 0, 30, 0, 0, 0, 10, 0, 0, 0, 10}, new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        assertThat(MeshMeasure.centreOfMass(Shapes.moved(tetrahedron, 500, -40, 8)))
                .containsExactly(new double[] {507.5, -37.5, 10.5}, within(ROUNDING));
        TriangleMesh two = Shapes.join(Shapes.box(10, 10, 10), Shapes.moved(Shapes.box(10, 20, 30), 70, 0, 0));
        assertThat(MeshMeasure.centreOfMass(two))
                .containsExactly(new double[] {65, (5 + 60) / 7.0, (5 + 90) / 7.0}, within(ROUNDING));
    }

    @Test
    void aSphereApproachesItsAreaVolumeAndNormals() {
        double r = 10;
        TriangleMesh sphere = Shapes.sphere(r, 5);
        assertThat(MeshMeasure.area(sphere) / (4 * Math.PI * r * r)).isCloseTo(1, within(2e-3));
        assertThat(MeshMeasure.signedVolume(sphere) / (4 * Math.PI * r * r * r / 3))
                .isCloseTo(1, within(2e-3));
        double[] normals = MeshMeasure.vertexNormals(sphere);
        for (int i = 0; i < normals.length; i++) {
            assertThat(normals[i]).isCloseTo(sphere.positions()[i] / r, within(2e-3));
        }
    }

    @Test
    void angleWeightedNormalsOfABoxPointAlongItsDiagonalsHoweverItsFacesAreCut() {
        double[] normals = MeshMeasure.vertexNormals(Shapes.box(1, 2, 3));
        for (double component : normals) {
            assertThat(Math.abs(component)).isCloseTo(1 / Math.sqrt(3), within(ROUNDING));
        }
    }

    @Test
    void vertexAreasSumToTheArea() {
        TriangleMesh torus = Shapes.torus(5, 1, 40, 20);
        double sum = 0;
        for (double area : MeshMeasure.vertexAreas(torus)) {
            sum += area;
        }
        assertThat(sum).isCloseTo(MeshMeasure.area(torus), within(ROUNDING));
    }

    @Test
    void theSmallestAngleOfHalfASquareIs45AndOfALineZero() {
        TriangleMesh mesh =
                new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0}, new int[] {0, 1, 2, 0, 1, 3});
        assertThat(MeshMeasure.smallestAngles(mesh)[0]).isCloseTo(45, within(ROUNDING));
        assertThat(MeshMeasure.smallestAngles(mesh)[1]).isZero();
    }

    @Test
    void edgeLengthsOfARectangle() {
        TriangleMesh sheet = Shapes.sheet(3, 4, 2, 2);
        MeshMeasure.EdgeLengths lengths = MeshMeasure.edgeLengthSummary(sheet, new MeshTopology(sheet));
        assertThat(lengths.minimum()).isEqualTo(3);
        assertThat(lengths.maximum()).isEqualTo(5);
        assertThat(lengths.mean()).isCloseTo((3 + 3 + 4 + 4 + 5) / 5.0, within(ROUNDING));
    }

    /** Of a cube without a face, the five area vectors that are left sum to one face. */
    @Test
    void opennessIsTheAreaOfTheHoleOverThatOfTheSurface() {
        TriangleMesh cube = Shapes.box(2, 2, 2);
        assertThat(MeshMeasure.openness(cube)).isCloseTo(0, within(ROUNDING));
        int[] t = java.util.Arrays.copyOfRange(cube.triangles(), 6, cube.triangles().length);
        assertThat(MeshMeasure.openness(new TriangleMesh(cube.positions(), t))).isCloseTo(0.2, within(ROUNDING));
        int[] face = java.util.Arrays.copyOf(cube.triangles(), 6);
        assertThat(MeshMeasure.openness(new TriangleMesh(cube.positions(), face)))
                .isCloseTo(1, within(ROUNDING));
        assertThat(MeshMeasure.hasInside(cube)).isTrue();
        assertThat(MeshMeasure.hasInside(new TriangleMesh(cube.positions(), face)))
                .isFalse();
    }
}
