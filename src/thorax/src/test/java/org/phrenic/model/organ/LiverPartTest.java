package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;

/** A liver 10 mm below a flat roof, where the equations of docs/model.md have solutions in closed form. */
class LiverPartTest {
    private static final double ROUNDING = 1e-9;
    /** Resistance of the organs below to a turn, docs/model.md. */
    private static final double BETA = 0.6;
    /** Error from the roof that is not quite flat: the square of 3 mm over 100 mm, about. */
    private static final double FLATNESS = 0.002;

    private final TriangleMesh sheet = DomeSheet.of(130, 90, 6, 3, 20, 0);
    private final TriangleMesh liver = lowered(DomeSheet.of(100, 70, 6, 3, 20, 0), 10);
    private final LiverPart part = part(liver);

    private LiverPart part(TriangleMesh liver) {
        Diaphragm diaphragm = Diaphragm.withTrefoilTendon(sheet);
        double[] noCrura = new double[sheet.vertexCount()];
        DiaphragmPart.Tissue tissue = new DiaphragmPart.Tissue(TissueLaw.membrane(300, 3), 10, 1, true, noCrura, 1, 1);
        return new LiverPart(
                new Structure("liver", StructureKind.LIVER, 0, Side.RIGHT, liver),
                new DiaphragmPart(diaphragm, tissue, new MassSpringBuilder()));
    }

    /**
     * At the distance from which nothing carries it, a point or two of the roof are in reach: no rotation fits them.
     */
    @Test
    void aLiverThatHardlyAnythingCarriesMovesOrStandsStill() {
        double[] down = moved(sheet.positions(), p -> new double[] {p[0], p[1], p[2] - 10});
        double carried = 0;
        double left = 100;
        while (left - carried > 1e-4) {
            double middle = 0.5 * (carried + left);
            // Beside the middle, for no two points to be equally near.
            LiverPart low = part(liver.withPositions(
                    moved(liver.positions(), p -> new double[] {p[0] + 3, p[1] + 2, p[2] - middle})));
            double[] at = low.positions(sheet.positions(), down);
            assertThat(at).as("%s mm", middle).doesNotContain(Double.NaN);
            boolean still = Arrays.equals(at, low.structure.mesh().positions());
            assertThat(low.isCarried()).as("%s mm", middle).isEqualTo(!still);
            double[] grams = new double[sheet.vertexCount()];
            low.hang(150, grams);
            assertThat(Arrays.stream(grams).sum()).as("%s mm", middle).isCloseTo(still ? 0 : 150, within(ROUNDING));
            carried = still ? carried : middle;
            left = still ? middle : left;
        }
        assertThat(left).isBetween(20.0, 90.0);
    }

    private static TriangleMesh lowered(TriangleMesh mesh, double mm) {
        return mesh.withPositions(moved(mesh.positions(), p -> new double[] {p[0], p[1], p[2] - mm}));
    }

    private static double[] moved(double[] positions, UnaryOperator<double[]> motion) {
        double[] out = new double[positions.length];
        for (int i = 0; i < out.length; i += 3) {
            double[] p = motion.apply(new double[] {positions[i], positions[i + 1], positions[i + 2]});
            System.arraycopy(p, 0, out, i, 3);
        }
        return out;
    }

    private double[] liverUnder(UnaryOperator<double[]> motionOfTheRoof) {
        return part.positions(sheet.positions(), moved(sheet.positions(), motionOfTheRoof));
    }

    private int vertex(int axis, int sign) {
        int best = 0;
        for (int v = 0; v < liver.vertexCount(); v++) {
            best = sign * liver.positions()[3 * v + axis] > sign * liver.positions()[3 * best + axis] ? v : best;
        }
        return best;
    }

    @Test
    void theTopGoesDownWithTheRoofAndTheLowerEdgeLessFar() {
        double[] now = liverUnder(p -> new double[] {p[0], p[1], p[2] - 10});
        int top = 3 * vertex(2, 1) + 2;
        int edge = 3 * vertex(2, -1) + 2;
        assertThat(now[top] - liver.positions()[top]).isCloseTo(-10, within(ROUNDING));
        assertThat(now[edge] - liver.positions()[edge]).isCloseTo(-8.2, within(ROUNDING));
    }

    /**
     * The roof turns by a small θ about the vertical. With u - T = θ × r, r flat and normal to θ, the minimum over ω of
     * Σ w |θ × r - ω × r|² + β ω² Σ w 2/3 r² is at ω = θ / (1 + 2/3 β).
     */
    @Test
    void theOrgansBelowReduceATurnOfTheRoof() {
        double theta = 0.01;
        double[] now = liverUnder(p -> new double[] {p[0] - theta * p[1], p[1] + theta * p[0], p[2]});
        int left = 3 * vertex(0, 1);
        int right = 3 * vertex(0, -1);
        double turned = (now[left + 1] - now[right + 1]) / (now[left] - now[right]);
        assertThat(turned / theta).isCloseTo(1 / (1 + 2 * BETA / 3), within(FLATNESS));
    }
}
