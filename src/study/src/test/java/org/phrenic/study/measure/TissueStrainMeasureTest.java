package org.phrenic.study.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Muscle that stretches is told from tendon that keeps its shape, however both are carried about. */
class TissueStrainMeasureTest {
    private static final int SIDE = 9;
    private static final double EXACT = 1e-9;

    /** A flat square of 8 x 8 mm whose left half, x up to 4, is tendon. */
    private static Surface sheet() {
        double[] p = new double[3 * SIDE * SIDE];
        boolean[] tendon = new boolean[SIDE * SIDE];
        int[] t = new int[6 * (SIDE - 1) * (SIDE - 1)];
        int k = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            p[3 * i] = x;
            p[3 * i + 1] = y;
            tendon[i] = x <= SIDE / 2;
            if (x < SIDE - 1 && y < SIDE - 1) {
                for (int corner : new int[] {i, i + 1, i + SIDE, i + 1, i + SIDE + 1, i + SIDE}) {
                    t[k++] = corner;
                }
            }
        }
        TriangleMesh mesh = new TriangleMesh(p, t);
        return new Surface("diaphragm", StructureKind.DIAPHRAGM, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, tendon);
    }

    private static Map<String, Double> moved(UnaryOperator<double[]> motion) {
        Surface rest = sheet();
        double[] now = rest.rest().positions().clone();
        for (int i = 0; i < now.length; i += 3) {
            System.arraycopy(motion.apply(new double[] {now[i], now[i + 1], now[i + 2]}), 0, now, i, 3);
        }
        Map<String, Double> values = new LinkedHashMap<>();
        new TissueStrainMeasure(new SceneGeometry(List.of(rest), Diaphragm.withTrefoilTendon(DomeSheet.adult(4))))
                .measureSheet(rest, now, values);
        assertThat(values).containsOnlyKeys(TissueStrainMeasure.NAMES);
        return values;
    }

    @Test
    void aRigidMotionChangesNothing() {
        Map<String, Double> values = moved(p -> new double[] {7 - p[1], 3 + p[0], 40});
        assertThat(values.values()).allSatisfy(v -> assertThat(v).isCloseTo(0, within(EXACT)));
    }

    @Test
    void aSheetStretchedByATenthEverywhereHasLongerEdgesInBothTissues() {
        Map<String, Double> values = moved(p -> new double[] {1.1 * p[0], 1.1 * p[1], 1.1 * p[2]});
        assertThat(values.get("muscle_edge_change_percent")).isCloseTo(10, within(EXACT));
        assertThat(values.get("tendon_edge_change_percent")).isCloseTo(10, within(EXACT));
    }

    @Test
    void muscleThatIsDrawnOutBesideItLeavesTheTendonAlone() {
        Map<String, Double> values = moved(p -> new double[] {p[0] <= 4 ? p[0] : 4 + 2 * (p[0] - 4), p[1], p[2]});
        assertThat(values.get("tendon_edge_change_percent")).isCloseTo(0, within(EXACT));
        assertThat(values.get("tendon_bent_mm")).isCloseTo(0, within(EXACT));
        // Of 100 edges 36 are doubled, 32 keep their length and 32 diagonals grow by the root of 2.5; rms, not mean.
        double diagonal = Math.sqrt(2.5) - 1;
        assertThat(values.get("muscle_edge_change_percent"))
                .isCloseTo(10 * Math.sqrt(36 + 32 * diagonal * diagonal), within(EXACT));
    }

    @Test
    void aTendonThatBendsIsNotRigidEvenWhereItHardlyStretches() {
        // Rolled up about a line along y, radius 5 mm.
        Map<String, Double> values =
                moved(p -> new double[] {5 * Math.sin(p[0] / 5), p[1], 5 * (1 - Math.cos(p[0] / 5))});
        assertThat(values.get("tendon_bent_mm")).isGreaterThan(0.1);
        assertThat(values.get("tendon_edge_change_percent")).isLessThan(1);
    }
}
