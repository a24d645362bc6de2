package org.phrenic.study.speed;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Decimator;
import org.phrenic.mesh.edit.WindowedSincFilter;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.SurfaceNet;

/**
 * The paper's meshing of one lung of 256 x 256 x 160 voxels, each run in a Java that has just started, and its parts.
 * One thread.
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 0)
@Measurement(iterations = 1)
@Fork(3)
@State(Scope.Thread)
public class MeshingBenchmark {
    private static final int COLUMNS = 256;
    private static final int ROWS = 256;
    private static final int SLICES = 160;
    private static final int[] PARTS = {0, 1};

    private LabelGrid grid;
    private double voxelMm;

    /** An ellipsoid of 2.3 l in voxels of 0.7 x 0.7 x 1.5 mm. */
    @Setup
    public void make() {
        byte[] labels = new byte[COLUMNS * ROWS * SLICES];
        for (int v = 0; v < labels.length; v++) {
            double x = (v % COLUMNS - 127.5) / 110;
            double y = (v / COLUMNS % ROWS - 127.5) / 95;
            double z = (v / COLUMNS / ROWS - 79.5) / 72;
            labels[v] = (byte) (x * x + y * y + z * z < 1 ? 1 : 0);
        }
        grid = LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {0.7, 0, 0, 0, 0, 0.7, 0, 0, 0, 0, 1.5, 0});
        voxelMm = Math.cbrt(grid.voxelVolume());
    }

    /** Isosurface alone. */
    @Benchmark
    public TriangleMesh surface() {
        return SurfaceNet.of(grid, PARTS).surface(1);
    }

    /** Isosurface, 20 iterations, half of the vertices, 200 iterations. */
    @Benchmark
    public TriangleMesh whole() {
        TriangleMesh smooth = SurfaceNet.of(grid, PARTS).smoothed(20, 0.2).surface(1);
        TriangleMesh half = Decimator.toVertexCount(smooth, smooth.vertexCount() / 2, 0.5 * voxelMm);
        return WindowedSincFilter.smooth(half, 200, 0.2);
    }
}
