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
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.mesh.query.SurfaceDistance;

/**
 * The distance of 6,633 vertices (the size of the paper's patient meshes) from as large a surface 16 mm away, on one
 * thread.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 7, time = 1)
@Fork(1)
@State(Scope.Thread)
public class DistanceBenchmark {
    /** Nodes of the paper's patient meshes, and initial distance of its third subject. */
    private static final int VERTICES = 6633;

    private static final double APART_MM = 16;

    private SurfaceDistance distance;
    private double[] points;
    private TriangleMesh reference;

    /** Two meshes of the virtual diaphragm with different vertices, one shifted down. */
    @Setup
    public void make() {
        TriangleMesh sheet = VirtualThorax.generate(VirtualThoraxParameters.preset("adult-male"), Resolution.MEDIUM)
                .structuresOf(StructureKind.DIAPHRAGM)
                .get(0)
                .mesh();
        reference = Remesher.toVertexCount(sheet, VERTICES + 2);
        points = Remesher.toVertexCount(sheet, VERTICES).positions().clone();
        for (int i = 2; i < points.length; i += 3) {
            points[i] -= APART_MM;
        }
        distance = new SurfaceDistance(reference);
    }

    /** Distances once the tree is there. */
    @Benchmark
    public double[] distances() {
        return distance.unsignedDistance(points);
    }

    /** The same with signs. */
    @Benchmark
    public double[] signedDistances() {
        return distance.signedDistance(points);
    }

    /** The tree and what signs need. */
    @Benchmark
    public SurfaceDistance tree() {
        return new SurfaceDistance(reference);
    }
}
