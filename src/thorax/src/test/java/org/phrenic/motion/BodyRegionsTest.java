package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Surface;

/** The regions of the coarse virtual man at rest. */
class BodyRegionsTest {
    private static final double EDGE_MM = 8;
    /** The skin farther from the midplane than this is cut off, relative to its half-breadth. */
    private static final double FLANKS = 0.85;

    private static Surface withRest(Surface s, TriangleMesh rest) {
        return new Surface(s.name(), s.kind(), s.level(), s.side(), rest, s.motion(), s.tendon());
    }

    /** The surfaces with a skin that is open on both sides, as that of a scan is where the arms are cut off. */
    private static List<Surface> withOpenFlanks(List<Surface> surfaces, double fromMm) {
        return surfaces.stream()
                .map(s -> s.kind() == StructureKind.SKIN ? withRest(s, withoutFlanks(s.rest(), fromMm)) : s)
                .toList();
    }

    private static TriangleMesh withoutFlanks(TriangleMesh skin, double fromMm) {
        int[] t = skin.triangles();
        int[] kept = IntStream.range(0, t.length)
                .filter(i -> IntStream.range(0, 3).anyMatch(k -> Math.abs(skin.x(t[i / 3 * 3 + k])) <= fromMm))
                .map(i -> t[i])
                .toArray();
        return new TriangleMesh(skin.positions(), kept);
    }

    private static byte[] labels(List<Surface> surfaces, Diaphragm sheet, VoxelBox box) {
        List<double[]> positions =
                surfaces.stream().map(s -> s.rest().positions()).toList();
        return new BodyRegions(surfaces, sheet).label(box, positions);
    }

    /** Lines along the columns pass both openings, which lets no part of the trunk between them lie outside. */
    @Test
    void aSkinThatIsOpenWhereTheArmsAreCutOffEnclosesTheTrunkAsAClosedOneDoes() {
        try (Simulation simulation = Runs.simulation(Runs.scenario())) {
            List<Surface> closed = new SceneSurfaces(simulation).surfaces();
            Diaphragm sheet = simulation.scene().diaphragm().diaphragm;
            TriangleMesh skin = closed.stream()
                    .filter(s -> s.kind() == StructureKind.SKIN)
                    .findFirst()
                    .orElseThrow()
                    .rest();
            assertThat(MeshMeasure.hasInside(skin)).isTrue();
            double[] b = skin.bounds();
            double cut = FLANKS * Math.min(-b[0], b[3]);
            VoxelBox box = VoxelBox.covering(new double[] {b[0], b[1], b[2]}, new double[] {b[3], b[4], b[5]}, EDGE_MM);
            byte[] expected = labels(closed, sheet, box);
            byte[] seen = labels(withOpenFlanks(closed, cut), sheet, box);
            double[] place = new double[3];
            int within = 0;
            for (int v = 0; v < seen.length; v++) {
                box.voxelToMm(v % box.columns(), 0, 0, place);
                if (Math.abs(place[0]) <= cut) {
                    within += expected[v] == BodyRegions.OUTSIDE ? 0 : 1;
                    assertThat(seen[v]).isEqualTo(expected[v]);
                }
            }
            assertThat(within).isGreaterThan(10_000);
        }
    }
}
