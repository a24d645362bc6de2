package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.SharedThorax;
import org.phrenic.mesh.TriangleMesh;

/** The ways down the thoracic face that the border of the lung can go. */
class RecessTracksTest {
    private static final double ROUNDING = 1e-9;

    private static double[] point(RecessTracks tracks, int number, TriangleMesh sheet) {
        double[] out = new double[3];
        for (int c = 3 * number; c < 3 * number + 3; c++) {
            for (int axis = 0; axis < 3; axis++) {
                out[axis] += tracks.weight[c] * sheet.positions()[3 * tracks.corner[c] + axis];
            }
        }
        return out;
    }

    private static double distance(double[] a, double[] b) {
        return MassSpringBuilder.distance(a, 0, b, 0);
    }

    @Test
    void aTrackRunsFromItsPointToTheInsertionInEvenSteps() {
        TriangleMesh sheet = DomeSheet.adult(20);
        Diaphragm diaphragm = Diaphragm.withTrefoilTendon(sheet);
        int[] flank = IntStream.range(0, sheet.vertexCount())
                .filter(v -> diaphragm.isThoracic(v) && sheet.z(v) > 20 && sheet.z(v) < 70)
                .toArray();
        RecessTracks tracks = new RecessTracks(
                new ThoracicFace(diaphragm), MassSpringBuilder.positionsOf(sheet.positions(), 0, flank));
        for (int i = 0; i < flank.length; i++) {
            double[] from = {sheet.x(flank[i]), sheet.y(flank[i]), sheet.z(flank[i])};
            assertThat(distance(point(tracks, tracks.start[i], sheet), from)).isLessThan(ROUNDING);
            double[] before = from;
            for (int p = tracks.start[i] + 1; p < tracks.start[i + 1]; p++) {
                double[] at = point(tracks, p, sheet);
                assertThat(at[2]).isLessThan(before[2]);
                // A step leaves the plane of its triangle where the sheet turns; it is put back on it.
                assertThat(distance(at, before))
                        .isBetween(0.8 * RecessTracks.SPACING_MM, RecessTracks.SPACING_MM + ROUNDING);
                before = at;
            }
            assertThat(before[2]).as("end of track %d", i).isLessThan(1.5 * RecessTracks.SPACING_MM);
        }
    }

    /**
     * The shortest ways from neighbouring places of the scanned sheet's flank lead to places 150 mm apart; a lung's
     * base was drawn through the dome between them.
     */
    @Test
    void tracksOfNeighboursOnTheScannedFlankEndSideBySide() {
        TriangleMesh sheet = SharedThorax.diaphragmSheet();
        Diaphragm diaphragm = Diaphragm.withTrefoilTendon(sheet);
        double[] box = sheet.bounds();
        double height = box[5] - box[2];
        double[] line = new double[3 * 60];
        double most = 0;
        int far = 0;
        for (int side = -1; side <= 1; side += 2) {
            for (int i = 0; i < 60; i++) {
                line[3 * i] = side * 200;
                line[3 * i + 1] = 0.5 * (box[1] + box[4]) - 30 + i;
                line[3 * i + 2] = box[2] + 0.6 * height;
            }
            RecessTracks tracks = new RecessTracks(new ThoracicFace(diaphragm), line);
            for (int i = 1; i < 60; i++) {
                double apart = distance(
                        point(tracks, tracks.start[i] - 1, sheet), point(tracks, tracks.start[i + 1] - 1, sheet));
                most = Math.max(most, apart);
                far += apart > 10 ? 1 : 0;
            }
        }
        // Its border steps from the costal margin to rib 11 and from that to rib 12.
        assertThat(far).as("neighbours whose ends are more than 10 mm apart").isLessThanOrEqualTo(4);
        assertThat(most).isLessThan(60);
    }
}
