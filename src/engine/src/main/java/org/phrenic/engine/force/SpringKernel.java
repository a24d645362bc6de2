package org.phrenic.engine.force;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.phrenic.engine.parallel.BlockedEdges;

/**
 * How the forces of springs are computed. All give the same bits, on any number of threads: which is used is a matter
 * of speed alone, and may be decided by measuring.
 */
public enum SpringKernel {
    /** Plain loops, one edge at a time, as the formula stands; the default. */
    LOOPS("loops"),
    /**
     * Batches of edges with vector instructions by name; only where Java was started with {@code --add-modules
     * jdk.incubator.vector}.
     */
    VECTOR("vector");

    private static final String MODULE = "jdk.incubator.vector";

    private final String label;

    SpringKernel(String label) {
        this.label = label;
    }

    /** Name in reports and options. */
    public String label() {
        return label;
    }

    /** @throws IllegalArgumentException if none has this label; the sentence lists them */
    public static SpringKernel of(String label) {
        return Arrays.stream(values())
                .filter(kernel -> kernel.label.equals(label))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("kernel: found '" + label + "', expected one of "
                        + Arrays.stream(values()).map(SpringKernel::label).collect(Collectors.joining(", "))));
    }

    /** Whether it can run in this Java virtual machine. */
    public boolean isAvailable() {
        return this != VECTOR || ModuleLayer.boot().findModule(MODULE).isPresent();
    }

    /** Those that can run here. */
    public static List<SpringKernel> available() {
        return Arrays.stream(values()).filter(SpringKernel::isAvailable).toList();
    }

    /**
     * The passes over entries in stars.
     *
     * @throws IllegalStateException if it cannot run here; one sentence says what is missing
     */
    List<EdgeBatch.Pass> starPasses(BlockedEdges edges, SpringData c) {
        if (!isAvailable()) {
            throw new IllegalStateException(
                    "kernel: found vector, but Java was started without --add-modules " + MODULE);
        }
        if (this == LOOPS) {
            return EdgeLoops.stars(edges, c);
        }
        int[] own = edges.own;
        int[] other = edges.other;
        List<EdgeBatch.Pass> passes = new ArrayList<>();
        passes.add((t, from, n) -> EdgeBatch.differencesInStars(own, other, t.x, t.difference, from, n));
        if (c.damping != 0) {
            passes.add((t, from, n) -> EdgeBatch.differencesInStars(own, other, t.v, t.rate, from, n));
        }
        passes.addAll(vectorMath().passes(c));
        passes.add((t, from, n) -> EdgeBatch.giveInStars(own, other, t.difference, t.force, from, n));
        return passes;
    }

    /**
     * By name: naming the class in code would let the virtual machine load it, and with it a module that need not be
     * there.
     */
    private static EdgeMath vectorMath() {
        try {
            return Class.forName("org.phrenic.engine.force.VectorMath")
                    .asSubclass(EdgeMath.class)
                    .getDeclaredConstructor()
                    .newInstance();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("kernel: the vector kernel was not built", e);
        }
    }
}
