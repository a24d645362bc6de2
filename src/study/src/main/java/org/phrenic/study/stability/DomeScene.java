package org.phrenic.study.stability;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.ActionLine;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * The engine alone on a dome that breathes: springs along the edges and between the faces, rigid links in its middle, a
 * rim carried by ribs, one action line, and soft springs that bring each node home.
 */
final class DomeScene implements StabilityScene {
    /** Largest relative length error that links are swept to, and sweeps at most, as in the scenes of the program. */
    private static final double LINK_TOLERANCE = 1e-6;

    private static final int LINK_SWEEPS = 50;
    private static final double[] CONSISTENT_LENGTHS = {1};
    private static final double[] CONFLICTING_LENGTHS = {1, 0.8, 1.2};
    private static final double LINKED_RADIUS = 55;
    private static final double LINE_RADIUS = 60;
    private static final double HOME_SHARE = 0.25;
    private static final double LINE_FORCE = 300;
    private final DomeParameters recipe;
    private final Workers workers = Workers.of(1);
    private final Stepper stepper;
    private final RigidLinks links;

    /**
     * Puts a dome together.
     *
     * @param kind the scheme
     * @param refinement more than 1 for a step of the stability limit over so much
     * @throws IllegalArgumentException with one sentence, if the scene is refused
     */
    DomeScene(DomeParameters recipe, IntegratorKind kind, int refinement) {
        this.recipe = recipe;
        DomeMesh mesh = recipe.mesh();
        double[] rest = mesh.positions();
        NodeLayout layout = NodeLayout.morton(rest);
        ParticleSystem system = new ParticleSystem(layout, rest, masses(rest.length / 3), workers);
        system.setViscosity(recipe.viscosity());
        int[][] edges = edges(mesh);
        system.add(Springs.between(layout, edges[0], edges[1])
                .stiffness(recipe.stiffness())
                .restLengthsAt(rest)
                .build());
        int[] free = IntStream.range(0, rest.length / 3)
                .filter(i -> Arrays.stream(mesh.rim()).noneMatch(r -> r == i))
                .toArray();
        double[] home = new double[free.length];
        Arrays.fill(home, recipe.homeSprings() ? HOME_SHARE * recipe.stiffness() : 0);
        system.add(new Attachments(layout, free, home, 0, PrescribedMotion.stationary(gather(rest, free))));
        ActionLine line = new ActionLine(layout, free, rest, 0, 0, LINE_RADIUS);
        DomeDrive breath = new DomeDrive(recipe, line, LINE_FORCE, gather(rest, mesh.rim()));
        system.add(breath);
        system.add(line);
        links = links(mesh, layout, rest);
        system.add(links);
        system.prescribe(mesh.rim(), breath);
        StabilityLimit limit = StabilityLimit.of(system);
        double dt = refinement == 1
                ? recipe.dtS()
                : CaseRun.SAMPLE_S
                        / Math.ceil(CaseRun.SAMPLE_S * refinement / Math.min(limit.largestStep(kind), recipe.dtS()));
        stepper = new Stepper(kind.create(system), dt, StepPolicy.SUBSTEP, limit);
    }

    private double[] masses(int nodes) {
        double[] mass = new double[nodes];
        double spread = Math.sqrt(recipe.massRatio());
        for (int i = 0; i < nodes; i++) {
            mass[i] = spread == 1 ? recipe.mass() : recipe.mass() * (i % 7 == 0 ? spread : 1 / spread);
        }
        return mass;
    }

    /** Each edge of both faces once, then a strut from each node of the upper face to that below it. */
    private static int[][] edges(DomeMesh mesh) {
        int[] t = mesh.triangles();
        long[] keys = IntStream.range(0, t.length)
                .mapToLong(i -> {
                    int next = t[i % 3 == 2 ? i - 2 : i + 1];
                    return (long) Math.min(t[i], next) << 32 | Math.max(t[i], next);
                })
                .sorted()
                .distinct()
                .toArray();
        int[] below = mesh.below();
        int[] upper =
                IntStream.range(0, below.length).filter(i -> below[i] != i).toArray();
        int[] a = new int[keys.length + upper.length];
        int[] b = new int[a.length];
        for (int i = 0; i < a.length; i++) {
            a[i] = i < keys.length ? (int) (keys[i] >>> 32) : upper[i - keys.length];
            b[i] = i < keys.length ? (int) keys[i] : below[upper[i - keys.length]];
        }
        return new int[][] {a, b};
    }

    /**
     * One link from each node of the middle to that below it, or three of three lengths, which no shape can have at
     * once.
     */
    private RigidLinks links(DomeMesh mesh, NodeLayout layout, double[] rest) {
        int[] below = mesh.below();
        int[] linked = IntStream.range(0, below.length)
                .filter(i -> below[i] != i && Math.hypot(rest[3 * i], rest[3 * i + 1]) < LINKED_RADIUS)
                .toArray();
        double[] shares = recipe.conflictingLinks() ? CONFLICTING_LENGTHS : CONSISTENT_LENGTHS;
        int[] a = new int[shares.length * linked.length];
        int[] b = new int[a.length];
        double[] length = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            a[i] = linked[i / shares.length];
            b[i] = below[a[i]];
            length[i] = shares[i % shares.length]
                    * NodeState.maxDistance(gather(rest, new int[] {a[i]}), gather(rest, new int[] {b[i]}));
        }
        return RigidLinks.gaussSeidelToLengths(layout, a, b, length, LINK_TOLERANCE, LINK_SWEEPS);
    }

    private static double[] gather(double[] p, int[] nodes) {
        double[] out = new double[3 * nodes.length];
        for (int i = 0; i < nodes.length; i++) {
            System.arraycopy(p, 3 * nodes[i], out, 3 * i, 3);
        }
        return out;
    }

    @Override
    public Stepper stepper() {
        return stepper;
    }

    @Override
    public void step() {
        stepper.step();
    }

    @Override
    public double linkError() {
        return links.error(system());
    }

    @Override
    public void close() {
        workers.close();
    }
}
