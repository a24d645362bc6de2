package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
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

    /** Radius of the hole in a lung. */
    private static final double HOLE_MM = 30;

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

    /** The triangle of the lung's surface is in the hole: on its lateral side, near its middle. */
    private static boolean isInHole(TriangleMesh lung, double[] bounds, int triangle) {
        int[] t = lung.triangles();
        return IntStream.range(3 * triangle, 3 * triangle + 3).allMatch(i -> {
            double lateral = lung.x(t[i]) - 0.5 * (bounds[0] + bounds[3]);
            double y = lung.y(t[i]) - 0.5 * (bounds[1] + bounds[4]);
            double z = lung.z(t[i]) - 0.5 * (bounds[2] + bounds[5]);
            return lateral < 0 && Math.hypot(y, z) < HOLE_MM;
        });
    }

    /** A line along the columns that passes the hole would leave the lung without having entered it. */
    @Test
    void aLungWithAHoleHasTheVoxelsOfTheWholeLung() {
        try (Simulation simulation = Runs.simulation(Runs.scenario())) {
            List<Surface> whole = new SceneSurfaces(simulation).surfaces();
            Diaphragm sheet = simulation.scene().diaphragm().diaphragm;
            int place = IntStream.range(0, whole.size())
                    .filter(i -> whole.get(i).name().equals("lung_R"))
                    .findFirst()
                    .orElseThrow();
            TriangleMesh lung = whole.get(place).rest();
            double[] b = lung.bounds();
            int[] t = lung.triangles();
            int[] kept = IntStream.range(0, t.length)
                    .filter(i -> !isInHole(lung, b, i / 3))
                    .map(i -> t[i])
                    .toArray();
            TriangleMesh open = new TriangleMesh(lung.positions(), kept);
            assertThat(t.length - kept.length).isPositive();
            assertThat(MeshMeasure.hasInside(open)).isTrue();
            List<Surface> opened = new ArrayList<>(whole);
            opened.set(place, withRest(whole.get(place), open));
            VoxelBox box = VoxelBox.covering(new double[] {b[0], b[1], b[2]}, new double[] {b[3], b[4], b[5]}, EDGE_MM);
            byte[] expected = labels(whole, sheet, box);
            byte[] seen = labels(opened, sheet, box);
            long voxels = count(expected, BodyRegions.FIRST + place);
            assertThat(voxels).isGreaterThan(1000);
            assertThat(count(seen, BodyRegions.FIRST + place)).isCloseTo(voxels, withinPercentage(1));
        }
    }

    private static long count(byte[] labels, int region) {
        return IntStream.range(0, labels.length)
                .filter(v -> labels[v] == (byte) region)
                .count();
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
