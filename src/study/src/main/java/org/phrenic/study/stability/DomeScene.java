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
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.Vectors;

/**
 * Synthetic breathing dome: springs along the edges and between the faces, rigid links in the middle, a rim with
 * prescribed motion, one action line, and soft springs that pull each node to its rest position.
 */
final class DomeScene implements StabilityScene {
    /** Tolerance of the relative length error; with the maximum number of sweeps as in the program's scenes. */
    private static final double LINK_TOLERANCE = 1e-6;

    private static final int LINK_SWEEPS = 50;
    private static final double[] CONSISTENT_LENGTHS = {1};
    private static final double[] CONFLICTING_LENGTHS = {1, 0.8, 1.2};
    private static final double LINKED_RADIUS = 55;
    private static final double LINE_RADIUS = 60;
    private static final double HOME_SHARE = 0.25;
    private static final double LINE_FORCE = 300;
    private final DomeParameters parameters;
    private final Workers workers = Workers.of(1);
    private final Stepper stepper;
    private final RigidLinks links;

    /**
     * Assembles a dome.
     *
     * @param kind scheme
     * @param refinement 1 for the time step of the parameters; otherwise the divisor of that step or of the stability
     *     limit, whichever is smaller
     * @throws IllegalArgumentException with one sentence, if the scene is refused
     */
    DomeScene(DomeParameters parameters, IntegratorKind kind, int refinement) {
        this.parameters = parameters;
        DomeMesh mesh = parameters.mesh;
        double[] rest = mesh.positions();
        NodeLayout layout = NodeLayout.morton(rest);
        ParticleSystem system = new ParticleSystem(layout, rest, masses(rest.length / 3), workers);
        system.setViscosity(parameters.viscosity);
        int[][] edges = edges(mesh);
        system.add(Springs.between(layout, edges[0], edges[1])
                .stiffness(parameters.stiffness)
                .restLengthsAt(rest)
                .build());
        int[] free = IntStream.range(0, rest.length / 3)
                .filter(i -> Arrays.stream(mesh.rim()).noneMatch(r -> r == i))
                .toArray();
        double[] home = new double[free.length];
        Arrays.fill(home, parameters.homeSprings ? HOME_SHARE * parameters.stiffness : 0);
        system.add(new Attachments(layout, free, home, 0, PrescribedMotion.stationary(Vectors.gather(rest, free))));
        ActionLine line = new ActionLine(layout, free, rest, 0, 0, LINE_RADIUS);
        DomeDrive breath = new DomeDrive(parameters, line, LINE_FORCE, Vectors.gather(rest, mesh.rim()));
        system.add(breath);
        system.add(line);
        links = links(mesh, layout, rest);
        system.add(links);
        system.prescribe(mesh.rim(), breath);
        StabilityLimit limit = StabilityLimit.of(system);
        double dt = refinement == 1
                ? parameters.dtS
                : CaseRun.SAMPLE_S
                        / Math.ceil(CaseRun.SAMPLE_S * refinement / Math.min(limit.largestStep(kind), parameters.dtS));
        stepper = new Stepper(kind.create(system), dt, StepPolicy.SUBSTEP, limit);
    }

    private double[] masses(int nodes) {
        double[] mass = new double[nodes];
        double spread = Math.sqrt(parameters.massRatio);
        Arrays.setAll(mass, i -> spread == 1 ? parameters.mass : parameters.mass * (i % 7 == 0 ? spread : 1 / spread));
        return mass;
    }

    /** Each edge of both faces once, then a strut from each node of the upper face to the node below it. */
    private static int[][] edges(DomeMesh mesh) {
        int[] edges = new EdgeTable(mesh.positions().length / 3, mesh.triangles(), 3).edges();
        int[] below = mesh.below();
        int[] upper =
                IntStream.range(0, below.length).filter(i -> below[i] != i).toArray();
        int count = edges.length / 2;
        int[] a = new int[count + upper.length];
        int[] b = new int[a.length];
        for (int i = 0; i < a.length; i++) {
            a[i] = i < count ? edges[2 * i] : upper[i - count];
            b[i] = i < count ? edges[2 * i + 1] : below[upper[i - count]];
        }
        return new int[][] {a, b};
    }

    /** One link from each middle node to the node below it, or three links of incompatible lengths. */
    private RigidLinks links(DomeMesh mesh, NodeLayout layout, double[] rest) {
        int[] below = mesh.below();
        int[] linked = IntStream.range(0, below.length)
                .filter(i -> below[i] != i && StrictMath.hypot(rest[3 * i], rest[3 * i + 1]) < LINKED_RADIUS)
                .toArray();
        double[] shares = parameters.conflictingLinks ? CONFLICTING_LENGTHS : CONSISTENT_LENGTHS;
        int[] a = new int[shares.length * linked.length];
        int[] b = new int[a.length];
        double[] length = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            a[i] = linked[i / shares.length];
            b[i] = below[a[i]];
            length[i] = shares[i % shares.length]
                    * NodeState.maxDistance(
                            Vectors.gather(rest, new int[] {a[i]}), Vectors.gather(rest, new int[] {b[i]}));
        }
        return RigidLinks.gaussSeidelToLengths(layout, a, b, length, LINK_TOLERANCE, LINK_SWEEPS);
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
