package org.phrenic.mesh.voxel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;

class SurfaceNetTest {
    private static final double ROUNDING = 1e-9;
    private static final int[] SAME = {0, 1, 2, 3};

    @Property(tries = 60, seed = "1")
    void everyPartOfRandomVoxelsIsClosedManifoldAndOutward(@ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        int side = 2 + random.nextInt(5);
        int parts = 1 + random.nextInt(3);
        double full = 0.2 + 0.6 * random.nextDouble();
        byte[] labels = new byte[side * side * side];
        for (int i = 0; i < labels.length; i++) {
            labels[i] = (byte) (random.nextDouble() < full ? 1 + random.nextInt(parts) : 0);
        }
        LabelGrid grid = LabelGrid.of(side, side, side, labels, affine(1, random.nextBoolean() ? 1 : -1, 1));
        SurfaceNet net = SurfaceNet.of(grid, SAME);
        for (int part = 1; part <= parts; part++) {
            TriangleMesh surface = net.surface(part);
            if (surface.triangleCount() > 0) {
                assertIsClosedManifold(surface);
                assertThat(MeshMeasure.signedVolume(surface)).isPositive();
            }
        }
    }

    private static void assertIsClosedManifold(TriangleMesh surface) {
        MeshTopology topology = new MeshTopology(surface);
        assertThat(topology.isClosed()).isTrue();
        assertThat(topology.isManifold()).isTrue();
        Set<Long> directed = new HashSet<>();
        int[] t = surface.triangles();
        for (int side = 0; side < t.length; side++) {
            long edge = (long) t[side] << 32 | t[EdgeTable.next(side, 3)];
            assertThat(directed.add(edge))
                    .as("each edge is run along once each way")
                    .isTrue();
        }
    }

    private static double[] affine(double dx, double dy, double dz) {
        return new double[] {dx, 0, 0, 5, 0, dy, 0, -3, 0, 0, dz, 2};
    }

    @Test
    void aBallHasTheVolumeAndPlaceOfItsVoxelsWhicheverWayTheAxesRun() {
        for (double[] affine : new double[][] {affine(1, 2, 3), affine(-1, 2, 3), affine(-1, -2, -3)}) {
            LabelGrid grid = LabelGridSamples.ellipsoid(40, 30, 20, affine, 15, 11, 7);
            double voxels = grid.counts()[1] * grid.voxelVolume();
            TriangleMesh surface = SurfaceNet.of(grid, SAME).surface(1);
            assertThat(MeshMeasure.signedVolume(surface)).isCloseTo(voxels, within(0.01 * voxels));
            assertThat(MeshMeasure.centreOfMass(surface)).containsExactly(centre(grid), within(0.1));
            assertThat(new MeshTopology(surface).eulerCharacteristic()).isEqualTo(2);
            TriangleMesh smooth = SurfaceNet.of(grid, SAME).smoothed(20, 0.2).surface(1);
            assertThat(MeshMeasure.signedVolume(smooth)).isCloseTo(voxels, within(0.01 * voxels));
        }
    }

    /** Mean of the centres of the labelled voxels, mm. */
    private static double[] centre(LabelGrid grid) {
        double[] mean = new double[3];
        double[] at = new double[3];
        int voxels = grid.counts()[1];
        for (int v = 0; v < grid.voxelCount(); v++) {
            if (grid.label(v) == 1) {
                grid.voxelToMm(
                        v % grid.columns(), v / grid.columns() % grid.rows(), v / grid.columns() / grid.rows(), at);
                Arrays.setAll(mean, axis -> mean[axis] + at[axis] / voxels);
            }
        }
        return mean;
    }

    @Test
    void neighboursMeetBeforeAndAfterSmoothing() {
        LabelGrid ball = LabelGridSamples.ellipsoid(24, 24, 24, affine(1, 1, 1), 9, 9, 9);
        byte[] halves = new byte[ball.voxelCount()];
        for (int v = 0; v < halves.length; v++) {
            halves[v] = (byte) (ball.label(v) == 0 ? 0 : v % 24 < 11 ? 1 : v / 24 % 24 < 12 ? 2 : 3);
        }
        LabelGrid grid = LabelGrid.of(24, 24, 24, halves, affine(1, 1, 1));
        for (SurfaceNet net :
                List.of(SurfaceNet.of(grid, SAME), SurfaceNet.of(grid, SAME).smoothed(20, 0.2))) {
            TriangleMesh whole = SurfaceNet.of(grid, new int[] {0, 1, 1, 1}).surface(1);
            double sum = 0;
            for (int part = 1; part <= 3; part++) {
                sum += MeshMeasure.signedVolume(net.surface(part));
            }
            double volume = MeshMeasure.signedVolume(whole);
            assertThat(sum).isCloseTo(volume, within(0.01 * volume));
            // Every vertex of the second part between it and the first is a vertex of the first.
            Set<List<Double>> first = vertices(net.surface(1));
            long shared =
                    vertices(net.surface(2)).stream().filter(first::contains).count();
            assertThat(shared).isGreaterThan(80);
        }
    }

    private static Set<List<Double>> vertices(TriangleMesh mesh) {
        Set<List<Double>> vertices = new HashSet<>();
        for (int v = 0; v < mesh.vertexCount(); v++) {
            vertices.add(List.of(mesh.x(v), mesh.y(v), mesh.z(v)));
        }
        return vertices;
    }

    @Test
    void voxelsThatTouchAtAnEdgeOrACornerAreApart() {
        byte[] edge = new byte[27];
        edge[0] = 1;
        edge[1 + 3] = 1;
        TriangleMesh two = SurfaceNet.of(LabelGrid.of(3, 3, 3, edge, affine(1, 1, 1)), SAME)
                .surface(1);
        assertThat(ConnectedComponents.of(two)).hasSize(2);
        assertIsClosedManifold(two);
    }

    @Test
    void whatTheBoxCutsIsClosedHalfAVoxelBeyondTheLastCentre() {
        byte[] all = new byte[8];
        Arrays.fill(all, (byte) 1);
        TriangleMesh cube =
                SurfaceNet.of(LabelGrid.of(2, 2, 2, all, affine(1, 1, 1)), SAME).surface(1);
        assertThat(cube.vertexCount()).isEqualTo(26);
        assertThat(cube.bounds()).containsExactly(new double[] {4.5, -3.5, 1.5, 6.5, -1.5, 3.5}, within(ROUNDING));
        assertThat(SurfaceNet.of(LabelGrid.of(2, 2, 2, all, affine(1, 1, 1)), SAME)
                        .surface(2)
                        .triangleCount())
                .isZero();
    }
}
