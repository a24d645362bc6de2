package org.phrenic.study.bare;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Steps per second of the bare workload on a generated dome: the engine on one and two threads, and an object per node
 * and spring.
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 7, time = 1)
@Fork(1)
public class BareBenchmark {

    /** The engine. */
    @State(Scope.Thread)
    public static class Engine {
        /** Vertices along a side: 6,728, 20,808, 84,050 and 336,200 nodes. */
        @Param({"58", "102", "205", "410"})
        public int side;

        @Param({"1", "2"})
        public int workers;

        @Param({"false", "true"})
        public boolean links;

        BareWorkload workload;

        @Setup(Level.Trial)
        public void make() {
            workload = new BareWorkload(Domes.scene(side, links), BareSettings.DEFAULT.withThreads(workers));
        }

        @TearDown(Level.Trial)
        public void close() {
            workload.close();
        }
    }

    /** The baseline. */
    @State(Scope.Thread)
    public static class Objects {
        @Param("102")
        public int objectSide;

        ObjectPerNode workload;

        @Setup(Level.Trial)
        public void make() {
            workload = new ObjectPerNode(Domes.scene(objectSide, false), BareSettings.DEFAULT);
        }
    }

    @Benchmark
    public void engine(Engine engine) {
        engine.workload.advance(1);
    }

    @Benchmark
    public void objectPerNode(Objects objects) {
        objects.workload.step();
    }
}
