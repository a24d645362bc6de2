package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.SharedThorax;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.scenario.Scenario;

/** Where the base of the lungs is when the recess is open. */
class LungsInADeepBreathTest {
    /** End of inspiration of the deep breath. */
    private static final double INSPIRED_S = 3.6;

    /**
     * What of the lungs' area would lie below the thoracic face of the sheet by more than this, mm, is in the abdomen.
     */
    private static final double THROUGH_MM = 6;

    /** Share of the base's vertices that lie through the sheet at full inspiration. */
    private static double through(Thorax thorax, String anatomy) {
        Scenario scenario = Runs.scenario("preset=deep", "sternum=kinematic", "anatomy=" + anatomy);
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            while (simulation.time() < INSPIRED_S) {
                simulation.step();
            }
            Scene scene = simulation.scene();
            double[] now = new double[scene.restPositions().length];
            scene.system().layout().toCaller(scene.system().positions(), now);
            DiaphragmPart part = scene.diaphragm();
            TriangleMesh sheet = part.diaphragm.sheet();
            double[] sheetNow = Arrays.copyOfRange(now, 3 * part.firstNode, 3 * (part.firstNode + sheet.vertexCount()));
            int[] face = IntStream.range(0, sheet.triangleCount())
                    .filter(part.diaphragm::isThoracicTriangle)
                    .flatMap(t -> IntStream.range(3 * t, 3 * t + 3))
                    .map(c -> sheet.triangles()[c])
                    .toArray();
            TriangleTree closed = new TriangleTree(new TriangleMesh(sheetNow, sheet.triangles()));
            TriangleTree thoracic = new TriangleTree(new TriangleMesh(sheetNow, face));
            TriangleTree.Hit hit = new TriangleTree.Hit();
            int[] base = scene.lungBase().orElseThrow().callerNodes();
            int count = 0;
            for (int node : base) {
                double x = now[3 * node];
                double y = now[3 * node + 1];
                double z = now[3 * node + 2];
                // From below the dome a way straight up leads through both faces of the sheet, from above through none.
                boolean below = closed.countAlongRay(x, y, z, 0, 0, 1, hit) >= 2;
                count += below && !thoracic.isWithin(x, y, z, THROUGH_MM, hit) ? 1 : 0;
            }
            return count / (double) base.length;
        }
    }

    /** Two of 1,256 vertices are, in a fold at the back. */
    @Test
    void hardlyAnyIsBelowTheSheet() {
        assertThat(through(Runs.male(), "virtual/adult-male")).isLessThan(0.002);
    }

    /**
     * Its border lies in the recess at rest already. On the shortest ways, and with a pleura that gave way, 9 % of the
     * base went through the dome, up to 30 mm deep.
     */
    @Test
    void atMostHalfAPercentOfTheScannedMansBaseIsBelowTheSheet() {
        assertThat(through(
                        SharedThorax.male(),
                        SharedThorax.path("anatomy/male-thorax").toString()))
                .isLessThan(0.005);
    }
}
