package org.phrenic.study.bare;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.Hashes;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/**
 * Mass-spring benchmark that compares engines at equal work. Each vertex is a particle. Each edge is a spring with a
 * dashpot and its initial length as rest length. Some vertices carry a constant load, others are fixed. Rigid links
 * between pairs are optional; they are corrected once after each step, half at each end along the line between the two
 * nodes. The run starts at rest.
 */
public final class BareWorkload implements AutoCloseable {
    /** Number of steps from rest after which displacement and hash are computed. */
    public static final int CHECKED_STEPS = 200;

    /** Label of the spring force kernel in reports and options: plain loops. */
    public static final String KERNEL = "loops";

    private static final int RUNS = 7;
    /** Number of warm-up steps, enough for just-in-time compilation to settle. */
    private static final int WARM_UP_STEPS = 1000;

    private final BareScene scene;
    private final BareSettings settings;
    private final Workers workers;
    private final ParticleSystem system;
    private final Integrator integrator;
    private final int edges;
    private long stepsDone;

    public BareWorkload(BareScene scene, BareSettings settings) {
        this.scene = scene;
        this.settings = settings;
        TriangleMesh mesh = scene.mesh();
        double[] rest = mesh.positions();
        int n = mesh.vertexCount();
        NodeLayout layout = NodeLayout.morton(rest);
        double[] mass = new double[n];
        Arrays.fill(mass, settings.mass());
        workers = Workers.of(settings.threads());
        system = new ParticleSystem(layout, rest, mass, workers);
        int[] pairs = new EdgeTable(mesh).edges();
        edges = pairs.length / 2;
        Springs springs = Springs.between(layout, column(pairs, 0), column(pairs, 1))
                .stiffness(settings.stiffness())
                .damping(settings.damping())
                .restLengthsAt(rest)
                .build();
        system.add(springs);
        double[] load = new double[3 * n];
        for (int i : scene.loaded()) {
            load[3 * i + 2] = settings.load();
        }
        system.add(new ConstantLoad(layout, load));
        system.fix(scene.fixed());
        if (scene.links().length > 0) {
            system.add(RigidLinks.singlePass(layout, column(scene.links(), 0), column(scene.links(), 1), rest));
        }
        integrator = settings.integrator().create(system);
    }

    private static int[] column(int[] pairs, int which) {
        int[] out = new int[pairs.length / 2];
        Arrays.setAll(out, i -> pairs[2 * i + which]);
        return out;
    }

    public int nodeCount() {
        return system.nodeCount();
    }

    public int edgeCount() {
        return edges;
    }

    /** Advances by a number of steps. */
    public void advance(int steps) {
        double h = settings.step();
        for (int i = 0; i < steps; i++) {
            integrator.step(stepsDone * h, h);
            stepsDone++;
        }
    }

    /** Mean z displacement of the loaded nodes since the start, mm; NaN without loaded nodes. */
    public double meanDz() {
        double[] now = new double[3];
        double sum = 0;
        for (int i : scene.loaded()) {
            system.position(i, now);
            sum += now[2] - scene.mesh().z(i);
        }
        return sum / scene.loaded().length;
    }

    /** SHA-256 over the bits of all positions, then all velocities, in vertex order. */
    public String stateSha256() {
        double[] x = new double[3 * system.nodeCount()];
        double[] v = new double[x.length];
        system.layout().toCaller(system.positions(), x);
        system.layout().toCaller(system.velocities(), v);
        return Hashes.sha256(x, v);
    }

    /**
     * Runs the benchmark: 200 checked steps, the roofline measurement, a warm-up and seven timed runs.
     *
     * @param scene mesh, fixed and loaded vertices, links
     * @param settings parameters
     */
    public static BareResult run(BareScene scene, BareSettings settings) {
        try (BareWorkload work = new BareWorkload(scene, settings)) {
            work.advance(CHECKED_STEPS);
            double dz = work.meanDz();
            String hash = work.stateSha256();
            Roofline bound = Roofline.measure(work.system.nodeCount(), work.edges, settings.threads());
            work.advance(WARM_UP_STEPS);
            double[] rate = new double[RUNS];
            for (int run = 0; run < RUNS; run++) {
                long start = System.nanoTime();
                work.advance(settings.steps());
                rate[run] = settings.steps() / ((System.nanoTime() - start) * 1e-9);
            }
            Arrays.sort(rate);
            int nodes = work.system.nodeCount();
            int links = scene.links().length / 2;
            String scheme = settings.integrator().label();
            double median = rate[RUNS / 2];
            return new BareResult(
                    median,
                    rate[0],
                    rate[RUNS - 1],
                    nodes,
                    work.edges,
                    links,
                    settings.threads(),
                    scheme,
                    KERNEL,
                    dz,
                    bound,
                    hash);
        }
    }

    /** Stops the worker threads. */
    @Override
    public void close() {
        workers.close();
    }
}
