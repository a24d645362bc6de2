package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

class DiaphragmTest {
    private static final int RINGS = 20;
    private static final double UNIT = 1e-9;

    private static Diaphragm dome;
    private static Diaphragm male;

    @BeforeAll
    static void make() {
        dome = Diaphragm.withTrefoilTendon(DomeSheet.adult(RINGS));
        male = Diaphragm.withTrefoilTendon(VirtualThorax.ofPreset("adult-male", Resolution.LOW)
                .find("diaphragm")
                .orElseThrow()
                .mesh());
    }

    private static int count(Diaphragm d, java.util.function.IntPredicate what) {
        return (int) IntStream.range(0, d.sheet().vertexCount()).filter(what).count();
    }

    private static double tendonShare(Diaphragm d) {
        double[] areas = MeshMeasure.vertexAreas(d.sheet());
        return IntStream.range(0, areas.length)
                        .filter(d::isTendon)
                        .mapToDouble(i -> areas[i])
                        .sum()
                / java.util.Arrays.stream(areas).sum();
    }

    @Test
    void theInsertionIsTheOuterBorderOfTheSheet() {
        for (int i = 0; i < dome.sheet().vertexCount(); i++) {
            assertThat(dome.isInserted(i)).isEqualTo(dome.sheet().z(i) == 0);
        }
    }

    @Test
    void anOpeningForAVesselIsNoInsertion() {
        Diaphragm open = Diaphragm.withTrefoilTendon(DomeSheet.of(130, 90, 110, 3, RINGS, 3));
        assertThat(count(open, open::isInserted)).isEqualTo(2 * 6 * RINGS);
        double highest = IntStream.range(0, open.sheet().vertexCount())
                .filter(open::isInserted)
                .mapToDouble(open.sheet()::z)
                .max()
                .orElseThrow();
        assertThat(highest).isZero();
    }

    @Test
    void theTendonHasItsShareOfTheAreaAndLiesOnTheRoof() {
        for (Diaphragm d : new Diaphragm[] {dome, male}) {
            TriangleMesh sheet = d.sheet();
            double[] box = sheet.bounds();
            double[] normals = MeshMeasure.vertexNormals(sheet);
            assertThat(tendonShare(d)).isCloseTo(Diaphragm.TENDON_SHARE, within(0.005));
            for (int i = 0; i < sheet.vertexCount(); i++) {
                if (d.isTendon(i)) {
                    assertThat(sheet.z(i)).isGreaterThan(0.5 * (box[2] + box[5]));
                    assertThat(Math.abs(normals[3 * i + 2])).isGreaterThan(0.2);
                    assertThat(d.isInserted(i)).isFalse();
                }
            }
        }
    }

    /** The border crosses edges, so the tendon has its share of the area whatever the triangles' size. */
    @Test
    void theBorderOfTheTendonEnclosesItsShareOnEveryMesh() {
        for (int rings : new int[] {8, 12, 20}) {
            Diaphragm d = Diaphragm.withTrefoilTendon(DomeSheet.adult(rings));
            TriangleMesh sheet = d.sheet();
            int[] t = sheet.triangles();
            double inside = 0;
            for (int i = 0; i < sheet.triangleCount(); i++) {
                double area = 0.5 * MeshMeasure.triangleCrossProduct(sheet, i, new double[3]);
                inside += area * shareInside(d, t[3 * i], t[3 * i + 1], t[3 * i + 2]);
            }
            assertThat(inside / MeshMeasure.area(sheet)).isCloseTo(Diaphragm.TENDON_SHARE, within(1e-6));
        }
    }

    /** Share of a triangle within a straight border, from where it crosses the edges. */
    private static double shareInside(Diaphragm d, int... corner) {
        int inside = 0;
        for (int c : corner) {
            inside += d.isTendon(c) ? 1 : 0;
        }
        if (inside == 0 || inside == 3) {
            return inside / 3;
        }
        int odd = 0;
        while (d.isTendon(corner[odd]) != (inside == 1)) {
            odd++;
        }
        double one = d.tendonShare(corner[odd], corner[(odd + 1) % 3]);
        double other = d.tendonShare(corner[odd], corner[(odd + 2) % 3]);
        return inside == 1 ? one * other : 1 - (1 - one) * (1 - other);
    }

    @Test
    void bothFacesOfTheTendonLieOverEachOther() {
        double[] areas = MeshMeasure.vertexAreas(male.sheet());
        double thoracic = 0;
        double all = 0;
        for (int i = 0; i < areas.length; i++) {
            if (male.isTendon(i)) {
                all += areas[i];
                thoracic += male.isThoracic(i) ? areas[i] : 0;
            }
        }
        assertThat(thoracic / all).isCloseTo(0.5, within(0.06));
    }

    /** Leaflets may touch at a corner or not quite; crumbs are no tendon. */
    @Test
    void theTendonHangsTogether() {
        for (Diaphragm d : new Diaphragm[] {dome, male}) {
            boolean[] seen = new boolean[d.sheet().vertexCount()];
            int all = count(d, d::isTendon);
            int inLargePieces = 0;
            for (int seed = 0; seed < seen.length; seed++) {
                int size = d.isTendon(seed) && !seen[seed] ? flood(d, seed, seen) : 0;
                inLargePieces += size >= 0.1 * all ? size : 0;
            }
            assertThat(inLargePieces).isGreaterThanOrEqualTo((int) (0.97 * all));
        }
    }

    private static int flood(Diaphragm d, int seed, boolean[] seen) {
        java.util.ArrayDeque<Integer> open = new java.util.ArrayDeque<>();
        open.add(seed);
        seen[seed] = true;
        int size = 0;
        while (!open.isEmpty()) {
            int v = open.remove();
            size++;
            for (int k = d.topology().vertexEdgeStart()[v]; k < d.topology().vertexEdgeStart()[v + 1]; k++) {
                int w = d.topology().otherVertex(d.topology().vertexEdges()[k], v);
                if (d.isTendon(w) && !seen[w]) {
                    seen[w] = true;
                    open.add(w);
                }
            }
        }
        return size;
    }

    @Test
    void abovePlaneTakesWhatLiesAboveIt() {
        Diaphragm plane = Diaphragm.withTendonAbovePlane(DomeSheet.adult(RINGS), MedianFrame.straight(), 80);
        for (int i = 0; i < plane.sheet().vertexCount(); i++) {
            assertThat(plane.isTendon(i)).isEqualTo(plane.sheet().z(i) > 80);
        }
    }

    @Test
    void fibresAreUnitVectorsInTheSheetAndThereAreNoneInTheTendon() {
        for (Diaphragm d : new Diaphragm[] {dome, male}) {
            double[] normals = MeshMeasure.triangleNormals(d.sheet());
            double[] f = d.fibreDirections();
            int without = 0;
            for (int t = 0; t < d.sheet().triangleCount(); t++) {
                double length = Math.sqrt(dot(f, f, 3 * t));
                if (d.isTendonTriangle(t)) {
                    assertThat(length).isZero();
                } else if (length == 0) {
                    without++;
                } else {
                    assertThat(length).isCloseTo(1, within(UNIT));
                    assertThat(dot(f, normals, 3 * t)).isCloseTo(0, within(UNIT));
                }
            }
            // Between three vertices of the insertion the field does not change.
            assertThat(without).isLessThan(d.sheet().triangleCount() / 10);
        }
    }

    @Test
    void fibresRunUpTheFlankFromTheInsertionToTheTendon() {
        TriangleMesh sheet = dome.sheet();
        int[] t = sheet.triangles();
        double[] f = dome.fibreDirections();
        int flank = 0;
        int up = 0;
        for (int k = 0; k < t.length; k += 3) {
            double z = (sheet.z(t[k]) + sheet.z(t[k + 1]) + sheet.z(t[k + 2])) / 3;
            if (z > 5 && z < 50) {
                flank++;
                // The dome's wall is within 40 degrees of upright here, and so is a fibre along it.
                up += f[k + 2] > 0.75 ? 1 : 0;
            }
        }
        assertThat(up).isGreaterThan((int) (0.95 * flank));
        assertThat(flank).isGreaterThan(400);
    }

    @Test
    void theWayFromTheInsertionIsMeasuredAlongTheSheet() {
        int top = 0;
        // A quarter of an ellipse with half axes 130 and 110 is 188.9 mm long, with 90 and 110 157.5; along edges at
        // most a sixth longer than the shortest.
        assertThat(dome.distanceFromInsertion(top)).isBetween(150.0, 1.16 * 157.5);
        assertThat(IntStream.range(0, dome.sheet().vertexCount())
                        .filter(dome::isInserted)
                        .mapToDouble(dome::distanceFromInsertion)
                        .max())
                .hasValue(0);
    }

    private static double dot(double[] a, double[] b, int at) {
        return a[at] * b[at] + a[at + 1] * b[at + 1] + a[at + 2] * b[at + 2];
    }
}
