package org.phrenic.engine.force;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Steps sheets of all kinds of springs with every kernel that can run here: a line for each with a hash over the bits
 * of the state.
 */
final class KernelProbe {
    /** 40 x 40 nodes: several blocks, and batches that are not full. */
    private static final int SIDE = 40;

    private static final int STEPS = 20;

    private KernelProbe() {}

    /** A kind of springs. */
    enum Springiness {
        PLAIN,
        EACH_ITS_OWN,
        CONTRACTILE,
        DASHPOTS,
        DASHPOTS_AND_EACH_ITS_OWN,
        DASHPOTS_AND_CONTRACTILE
    }

    /**
     * @param kind of springs
     * @param kernel by name
     * @param threads that share the work
     * @param hash over the bits of positions and velocities
     */
    record Line(String kind, String kernel, int threads, int hash) {}

    /** Prints the lines; run in another process by a test, with the module of vector instructions. */
    public static void main(String[] args) {
        lines().forEach(line ->
                System.out.println(line.kind() + " " + line.kernel() + " " + line.threads() + " " + line.hash()));
    }

    static List<Line> lines() {
        List<Line> lines = new ArrayList<>();
        for (Springiness kind : Springiness.values()) {
            for (SpringKernel kernel : SpringKernel.available()) {
                for (int threads = 1; threads <= 3; threads++) {
                    lines.add(new Line(kind.name(), kernel.label(), threads, hash(kind, kernel, threads)));
                }
            }
        }
        return lines;
    }

    private static int hash(Springiness kind, SpringKernel kernel, int threads) {
        Random random = new Random(7);
        double[] x = new double[3 * SIDE * SIDE];
        Arrays.setAll(x, i -> (i % 3 == 0 ? i / 3 % SIDE : i % 3 == 1 ? i / 3 / SIDE : 0) + 0.3 * random.nextDouble());
        double[] mass = new double[SIDE * SIDE];
        Arrays.fill(mass, 0.1);
        int[] a = new int[3 * SIDE * (SIDE - 1)];
        int[] b = new int[a.length];
        int n = 0;
        for (int i = 0; i + SIDE < mass.length; i++) {
            a[n] = i;
            b[n++] = i + SIDE;
            if (i % SIDE < SIDE - 1) {
                a[n] = i;
                b[n++] = i + 1;
                a[n] = i + 1;
                b[n++] = i + SIDE;
            }
        }
        NodeLayout layout = NodeLayout.morton(x);
        double[] perEdge = random.doubles(n, 5, 20).toArray();
        Springs.Builder builder = Springs.between(layout, Arrays.copyOf(a, n), Arrays.copyOf(b, n))
                .restLengthsAt(x);
        builder = kind == Springiness.PLAIN || kind == Springiness.DASHPOTS
                ? builder.stiffness(15)
                : builder.stiffness(perEdge);
        if (kind == Springiness.CONTRACTILE || kind == Springiness.DASHPOTS_AND_CONTRACTILE) {
            builder.contractileShares(Arrays.stream(perEdge).map(k -> k / 20).toArray());
        }
        if (kind.name().startsWith("DASHPOTS")) {
            builder.damping(0.02);
        }
        try (Workers workers = Workers.of(threads)) {
            ParticleSystem system = new ParticleSystem(layout, x, mass, workers);
            Springs springs = builder.build();
            springs.setKernel(kernel);
            springs.setActivation(0.3);
            system.add(springs);
            double[] v = system.velocities();
            Arrays.setAll(v, i -> random.nextGaussian());
            Integrator integrator = IntegratorKind.VERLET.create(system);
            for (int i = 0; i < STEPS; i++) {
                integrator.step(0.01 * i, 0.01);
            }
            return 31 * Arrays.hashCode(system.positions()) + Arrays.hashCode(v);
        }
    }
}
