package org.phrenic.model.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.organ.SpringList;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class PrestressTest {
    private static final double PRESSURE_KPA = 0.3;

    @Test
    void aLoadBetweenTwoSlantingSpringsGivesTheirTensionInClosedForm() {
        // Ends at (-3, 4) and (3, 4), the load 16 mN down at the origin: T = 16 / (2 cos) = 16 / (2 * 4 / 5) = 10 mN.
        double[] p = {0, 0, 0, -3, 0, 4, 3, 0, 4};
        Prestress prestress =
                new Prestress(p, new int[] {0, 0}, new int[] {1, 2}, new boolean[] {true, false, false}, new double[9]);
        double[] load = {0, 0, -16, 0, 0, 0, 0, 0, 0};
        double[] tension = new double[2];
        assertThat(prestress.solve(load, tension, 10)).isCloseTo(0, within(1e-9));
        assertThat(tension).containsExactly(new double[] {10, 10}, within(1e-9));
    }

    @Test
    void aNodeThatLeansOnTheWallNeedsNoTensionAcrossIt() {
        double[] p = {0, 0, 0, 0, 0, 4};
        Prestress prestress = new Prestress(
                p, new int[] {0}, new int[] {1}, new boolean[] {true, false}, new double[] {1, 0, 0, 0, 0, 0});
        double[] load = {-50, 0, -7, 0, 0, 0};
        double[] tension = new double[1];
        assertThat(prestress.solve(load, tension, 5)).isCloseTo(0, within(1e-9));
        assertThat(tension[0]).isCloseTo(7, within(1e-9));
    }

    @Test
    void withoutLoadNothingIsPulled() {
        Prestress prestress = new Prestress(
                new double[] {0, 0, 0, 1, 0, 0},
                new int[] {0},
                new int[] {1},
                new boolean[] {true, false},
                new double[6]);
        double[] tension = new double[1];
        assertThat(prestress.solve(new double[6], tension, 5)).isZero();
        assertThat(tension).containsOnly(0);
    }

    /**
     * A spherical double-layered sheet of 100 mm radius, pressed from inside, its rim held: Laplace's tension shared by
     * two faces carries it.
     */
    @Test
    void aPressedDomeIsHeldInItsShapeByTensionsOfLaplacesSize() {
        double radius = 100;
        int rings = 12;
        TriangleMesh sheet = DomeSheet.of(radius, radius, radius, 3, rings, 0);
        Diaphragm d = Diaphragm.withTrefoilTendon(sheet);
        SpringList springs = new SpringList();
        TissueLaw.membrane(300, 60).addEdges(springs, sheet, 0, 1);
        int edges = springs.count();
        for (OpposingVertices.Pair pair : OpposingVertices.of(d, 20).nearestPairs(3)) {
            springs.add(pair.a(), pair.b(), 40, 3, 0);
        }
        int n = sheet.vertexCount();
        double[] load = new double[3 * n];
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] areas = MeshMeasure.vertexAreas(sheet);
        boolean[] free = new boolean[n];
        for (int i = 0; i < n; i++) {
            free[i] = !d.isInserted(i);
            for (int axis = 0; axis < 3; axis++) {
                load[3 * i + axis] = d.isThoracic(i) ? 0 : -PRESSURE_KPA * areas[i] * normals[3 * i + axis];
            }
        }
        Prestress prestress =
                new Prestress(sheet.positions(), springs.nodeA(), springs.nodeB(), free, new double[3 * n]);
        double spacing = Math.sqrt(MeshMeasure.area(sheet) / n);
        double laplace = PRESSURE_KPA * radius / 2 / 2 * spacing;
        double[] tension = new double[springs.count()];
        Arrays.fill(tension, laplace);
        assertThat(prestress.solve(load, tension, 300)).isLessThan(0.05);
        double mean = Arrays.stream(tension, 0, edges).average().orElseThrow();
        assertThat(mean).isBetween(0.5 * laplace, 1.5 * laplace);
    }

    /**
     * In the whole scene what tensions leave is carried by a dead load, and the given shape is nearly that of
     * equilibrium.
     */
    @Test
    void theVirtualSheetHardlyMovesWhenItSettles() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.SHEET_ALONE))) {
            assertThat(simulation.scene().prestressResidual()).isLessThan(0.26);
            // 1.0 mm rms as measured: a hundredth of the height of the dome.
            assertThat(simulation.settlingDisplacementMm()).isLessThan(1.5);
        }
    }
}
