package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

class TissueLawTest {
    private static final double SHEET_N_PER_M = 300;
    private static final double DENSITY_KG_PER_M2 = 60;
    private static final TissueLaw LAW = TissueLaw.membrane(SHEET_N_PER_M, DENSITY_KG_PER_M2);

    /** A rectangle of nearly equilateral triangles whose vertices are shaken by up to an eighth of an edge. */
    private static TriangleMesh patch(double width, double height, int columns) {
        double edge = width / (columns - 1);
        int rows = (int) Math.round(height / (edge * Math.sqrt(3) / 2)) + 1;
        double[] p = new double[3 * rows * columns];
        for (int r = 0; r < rows; r++) {
            for (int c = 0; c < columns; c++) {
                int i = r * columns + c;
                boolean inside = r > 0 && r < rows - 1 && c > 0 && c < columns - 1;
                double shake = inside ? edge / 8 : 0;
                double shift = r % 2 == 0 || c == 0 || c == columns - 1 ? 0 : edge / 2;
                p[3 * i] = edge * c + shift + shake * Math.sin(12.9 * i);
                p[3 * i + 1] = height * r / (rows - 1) + shake * Math.sin(78.2 * i);
            }
        }
        int[] t = new int[6 * (rows - 1) * (columns - 1)];
        int k = 0;
        for (int r = 0; r + 1 < rows; r++) {
            for (int c = 0; c + 1 < columns; c++) {
                int a = r * columns + c;
                int b = a + columns;
                int[] two = r % 2 == 0
                        ? new int[] {a, a + 1, b, a + 1, b + 1, b}
                        : new int[] {a, a + 1, b + 1, a, b + 1, b};
                System.arraycopy(two, 0, t, k, 6);
                k += 6;
            }
        }
        return new TriangleMesh(p, t);
    }

    /**
     * Pulls a patch at its right edge, lets it come to rest (overdamped), and reads E h off the force: force = E h
     * strain height.
     */
    private static double pulled(TriangleMesh patch, double height) {
        SpringList springs = new SpringList();
        LAW.addEdges(springs, patch, 0, 1);
        double[] box = patch.bounds();
        double strain = 0.02;
        double[] x = patch.positions().clone();
        int n = patch.vertexCount();
        for (int i = 0; i < n; i++) {
            x[3 * i] *= 1 + strain;
        }
        double mobility = 0.15 / Arrays.stream(springs.stiffness()).max().orElseThrow();
        double pull = 0;
        double[] velocity = new double[2 * n];
        for (int round = 0; round < 4000; round++) {
            double[] force = forces(springs, x, n);
            pull = 0;
            for (int i = 0; i < n; i++) {
                boolean left = patch.x(i) < box[0] + 1e-9;
                boolean right = patch.x(i) > box[3] - 1e-9;
                pull -= right ? force[2 * i] : 0;
                for (int axis = 0; axis < 2; axis++) {
                    int j = 2 * i + axis;
                    velocity[j] = axis == 0 && (left || right) ? 0 : 0.95 * velocity[j] + mobility * force[j];
                    x[3 * i + axis] += velocity[j];
                }
            }
        }
        return pull / (strain * height);
    }

    private static double[] forces(SpringList springs, double[] x, int nodes) {
        int[] a = springs.nodeA();
        int[] b = springs.nodeB();
        double[] k = springs.stiffness();
        double[] rest = springs.rest();
        double[] force = new double[2 * nodes];
        for (int e = 0; e < a.length; e++) {
            double dx = x[3 * b[e]] - x[3 * a[e]];
            double dy = x[3 * b[e] + 1] - x[3 * a[e] + 1];
            double length = Math.hypot(dx, dy);
            double f = k[e] * (length - rest[e]) / length;
            force[2 * a[e]] += f * dx;
            force[2 * a[e] + 1] += f * dy;
            force[2 * b[e]] -= f * dx;
            force[2 * b[e] + 1] -= f * dy;
        }
        return force;
    }

    /** Lloyd, Székely and Harders 2007; a face has half of the sheet's stiffness. */
    @ParameterizedTest
    @ValueSource(ints = {11, 21})
    void aPulledPatchHasTheWantedMembraneStiffnessAtAnyResolution(int columns) {
        double eh = pulled(patch(100, 60, columns), 60);
        assertThat(eh).isCloseTo(SHEET_N_PER_M / 2, Percentage.withPercentage(15));
    }

    @Test
    void massIsAreaTimesDensityAtAnyResolution() {
        TriangleMesh coarse = DomeSheet.adult(14);
        TriangleMesh fine = DomeSheet.adult(28);
        double heavy = Arrays.stream(LAW.masses(coarse, 1)).sum();
        assertThat(heavy).isCloseTo(1e-6 * DENSITY_KG_PER_M2 * MeshMeasure.area(coarse), Percentage.withPercentage(1));
        assertThat(Arrays.stream(LAW.masses(fine, 1)).sum()).isCloseTo(heavy, Percentage.withPercentage(1));
    }

    /** Two halves of a square of 30 mm, and beside one edge a triangle of a hundredth of a millimetre. */
    @Test
    void theVertexOfASliverHasATenthOfTheMeanArea() {
        TriangleMesh sheet = new TriangleMesh(
                new double[] {0, 0, 0, 30, 0, 0, 30, 30, 0, 0, 30, 0, 15, -0.01, 0},
                new int[] {0, 1, 2, 0, 2, 3, 0, 4, 1});
        double sliver = 0.15;
        double[] areas = {300 + sliver / 3, 150 + sliver / 3, 300, 150, (900 + sliver) / 5 / 10};
        double[] masses = LAW.masses(sheet, 2);
        double[] factors = LAW.beddingFactors(sheet);
        for (int v = 0; v < areas.length; v++) {
            assertThat(masses[v]).isCloseTo(2e-6 * DENSITY_KG_PER_M2 * areas[v], Percentage.withPercentage(1e-9));
            assertThat(factors[v]).isCloseTo(areas[v] / TissueLaw.BEDDING_AREA_MM2, Percentage.withPercentage(1e-9));
        }
    }

    @Test
    void aBedIsAsFirmUnderACoarseMeshAsUnderAFineOne() {
        for (int rings : new int[] {14, 28}) {
            TriangleMesh dome = DomeSheet.adult(rings);
            assertThat(Arrays.stream(LAW.beddingFactors(dome)).sum())
                    .isCloseTo(MeshMeasure.area(dome) / TissueLaw.BEDDING_AREA_MM2, Percentage.withPercentage(1));
        }
    }

    @Test
    void tendonIsAsMuchHeavierAsItIsStifferSoThatAllTissueHasOneWaveSpeed() {
        TriangleMesh dome = DomeSheet.adult(8);
        assertThat(LAW.masses(dome, 10)[5]).isCloseTo(10 * LAW.masses(dome, 1)[5], within(1e-12));
        assertThat(LAW.edgeStiffness(2, 10)).isCloseTo(10 * LAW.edgeStiffness(2, 1), within(1e-9));
        assertThat(LAW.edgeStiffness(1, 1)).isCloseTo(LAW.edgeStiffness(2, 1) / 2, within(1e-9));
    }

    @Test
    void thePaperHasOneStiffnessAndOneMassForAll() {
        TissueLaw paper = TissueLaw.uniform(15, 0.1);
        assertThat(paper.masses(DomeSheet.adult(5), 10)).containsOnly(0.1);
        assertThat(paper.beddingFactors(DomeSheet.adult(5))).containsOnly(1);
        assertThat(paper.edgeStiffness(2, 1)).isEqualTo(15).isEqualTo(paper.edgeStiffness(1, 1));
    }

    @Test
    void everyEdgeIsASpringAtItsLength() {
        TriangleMesh dome = DomeSheet.adult(5);
        int edges = new MeshTopology(dome).edgeCount();
        SpringList plain = new SpringList();
        LAW.addEdges(plain, dome, 100, 1);
        assertThat(plain.count()).isEqualTo(edges);
        assertThat(plain.contractileShare()).containsOnly(0);
        for (int e = 0; e < plain.count(); e++) {
            assertThat(plain.nodeA()[e]).isGreaterThanOrEqualTo(100);
            assertThat(plain.rest()[e])
                    .isEqualTo(MassSpringBuilder.distance(
                            dome.positions(), plain.nodeA()[e] - 100, dome.positions(), plain.nodeB()[e] - 100))
                    .isPositive();
        }
    }
}
