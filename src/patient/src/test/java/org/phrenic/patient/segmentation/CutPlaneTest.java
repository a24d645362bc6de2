package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.MeshedSegment;
import org.phrenic.patient.PatientStructure;

/** The end of a scan whose slices are tilted by 30 degrees about the axis from right to left. */
class CutPlaneTest {
    private static final double SINE = 0.5;
    private static final double COSINE = Math.sqrt(0.75);
    /** Voxels of 1, 1 and 2 mm, the first at (10, 20, 30). */
    private static final double[] TO_MM = {1, 0, 0, 10, 0, COSINE, -2 * SINE, 20, 0, SINE, 2 * COSINE, 30};

    @Test
    void thePlaneIsTheOuterFaceOfTheLayer() {
        CutPlane below = CutPlane.ofLayer(TO_MM, 2, 0, false);
        assertThat(below.side()).isEqualTo("I");
        assertThat(new double[] {below.x(), below.y(), below.z()})
                .containsExactly(new double[] {0, SINE, -COSINE}, within(1e-15));
        // The face lies half a voxel, 1 mm, beyond the centres of the layer.
        double[] face = {10, 20 + SINE, 30 - COSINE};
        assertThat(below.isReachedBy(face, 0, 1e-9)).isTrue();
        assertThat(below.isReachedBy(face, 0, -1e-9)).isFalse();
        CutPlane above = CutPlane.ofLayer(TO_MM, 2, 9, true);
        assertThat(above.side()).isEqualTo("S");
        assertThat(above.offsetMm()).isCloseTo(-below.offsetMm() + 20, within(1e-12));
    }

    /** In LPS the axes of the first grid run to L, P and S; those of the second to A, I and R. */
    @Test
    void eachEndHasTheLetterOfItsSideOfTheBody() {
        double[] turned = {0, 0, -3, 0, -2, 0, 0, 0, 0, -2, 0, 0};
        String[][] sides = {{"R", "L", "A", "P", "I", "S"}, {"P", "A", "S", "I", "L", "R"}};
        for (int grid = 0; grid < 2; grid++) {
            for (int end = 0; end < 6; end++) {
                CutPlane plane = CutPlane.ofLayer(grid == 0 ? TO_MM : turned, end / 2, 4, end % 2 == 1);
                assertThat(plane.side()).as("grid %s, end %s", grid, end).isEqualTo(sides[grid][end]);
            }
        }
    }

    /** An organ ends on the tilted face; afterwards it is raised by 40 mm. */
    @Test
    void verticesOnTheFaceAreKnownWhereverTheyWereMoved() {
        double[] p = new double[30];
        for (int v = 0; v < 10; v++) {
            // Even vertices lie on the face, odd ones 20 mm inside.
            double inside = v % 2 == 0 ? 0 : 20;
            p[3 * v] = 10 + v;
            p[3 * v + 1] = 20 + SINE - SINE * inside + COSINE * 3 * v;
            p[3 * v + 2] = 30 - COSINE + COSINE * inside + SINE * 3 * v;
        }
        TriangleMesh shown = new TriangleMesh(p, new int[] {0, 1, 2, 3, 4, 5, 6, 7, 8, 7, 8, 9});
        MeshedSegment meshed = new MeshedSegment(shown, 0, 0, DistanceSummary.NONE, MeshQuality.of(shown), 0.2, 1, 0);
        double[] raised = p.clone();
        for (int i = 2; i < raised.length; i += 3) {
            raised[i] += 40;
        }
        PatientStructure organ = PatientStructure.ofScan(
                        new Structure("liver", StructureKind.LIVER, 0, Side.MIDLINE, shown),
                        new PatientStructure.Scan(
                                List.of(1), 1, 1, List.of(CutPlane.ofLayer(TO_MM, 2, 0, false)), meshed))
                .withStructure(
                        new Structure("liver", StructureKind.LIVER, 0, Side.MIDLINE, shown.withPositions(raised)));
        assertThat(organ.scan().orElseThrow().cutAt()).isEqualTo("I");
        assertThat(organ.verticesAtCut(8))
                .containsExactly(true, false, true, false, true, false, true, false, true, false);
    }
}
