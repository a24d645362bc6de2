package org.phrenic.engine;

import java.util.Arrays;
import java.util.Random;
import java.util.TreeSet;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Small systems with known behaviour, and one large one with everything in it. */
public final class SampleSystems {
    private SampleSystems() {}

    /** As many masses of m. */
    public static double[] masses(int n, double m) {
        double[] mass = new double[n];
        Arrays.fill(mass, m);
        return mass;
    }

    /** One node at the origin. */
    public static ParticleSystem oneNode(double m) {
        return new ParticleSystem(NodeLayout.natural(1), new double[3], new double[] {m}, Workers.of(1));
    }

    /** One node on a spring of no rest length to the origin: ẍ = -k/m x - γ/m ẋ. */
    public static ParticleSystem oscillator(double m, double k, double gamma) {
        ParticleSystem system = oneNode(m);
        system.add(new Attachments(
                system.layout(), new int[] {0}, new double[] {k}, 0, PrescribedMotion.stationary(new double[3])));
        system.setViscosity(gamma);
        return system;
    }

    /** The edges of a net of n x n x n nodes (every pair nearer than 1.5 spacings), as two lists of ends. */
    public static int[][] gridEdges(int n) {
        TreeSet<Long> edges = new TreeSet<>();
        for (int i = 0; i < n * n * n; i++) {
            for (int j = i + 1; j < n * n * n; j++) {
                int dx = i % n - j % n;
                int dy = i / n % n - j / n % n;
                int dz = i / n / n - j / n / n;
                if (dx * dx + dy * dy + dz * dz <= 2) {
                    edges.add((long) i << 32 | j);
                }
            }
        }
        return ends(edges);
    }

    /** Nodes of that net, 10 mm apart, each shifted at random by up to {@code jitter} mm an axis (fixed seed). */
    public static double[] gridPositions(int n, double jitter, long seed) {
        Random random = new Random(seed);
        double[] x = new double[3 * n * n * n];
        for (int i = 0; i < n * n * n; i++) {
            x[3 * i] = 10 * (i % n) + jitter * (2 * random.nextDouble() - 1);
            x[3 * i + 1] = 10 * (i / n % n) + jitter * (2 * random.nextDouble() - 1);
            x[3 * i + 2] = 10 * (i / n / n) + jitter * (2 * random.nextDouble() - 1);
        }
        return x;
    }

    /**
     * A free net of 3 x 3 x 3 nodes out of its rest shape, with a spin and a throw: large motions, nonlinear forces.
     */
    public static ParticleSystem net(double dashpot) {
        double[] rest = gridPositions(3, 0, 1);
        double[] x = gridPositions(3, 1.5, 7);
        int[][] edges = gridEdges(3);
        Random random = new Random(11);
        double[] mass = new double[27];
        Arrays.setAll(mass, i -> 0.05 + 0.1 * random.nextDouble());
        ParticleSystem system = new ParticleSystem(NodeLayout.natural(27), x, mass, Workers.of(1));
        system.add(Springs.between(system.layout(), edges[0], edges[1])
                .stiffness(4)
                .restLengthsAt(rest)
                .damping(dashpot)
                .build());
        for (int i = 0; i < 27; i++) {
            system.velocities()[3 * i] = 5 - 1.5 * x[3 * i + 1];
            system.velocities()[3 * i + 1] = 1.5 * x[3 * i];
            system.velocities()[3 * i + 2] = -3;
        }
        return system;
    }

    /** Two ends of each edge from keys that hold both. */
    public static int[][] ends(TreeSet<Long> edges) {
        return new int[][] {
            edges.stream().mapToInt(e -> (int) (e >> 32)).toArray(),
            edges.stream().mapToInt(e -> (int) (long) e).toArray()
        };
    }

    /** The edges of a triangle mesh, each once. */
    public static int[][] edgesOf(int[] triangles) {
        TreeSet<Long> edges = new TreeSet<>();
        for (int t = 0; t < triangles.length; t += 3) {
            for (int c = 0; c < 3; c++) {
                int a = triangles[t + c];
                int b = triangles[t + (c + 1) % 3];
                edges.add((long) Math.min(a, b) << 32 | Math.max(a, b));
            }
        }
        return ends(edges);
    }

    /**
     * Two sheets of {@code columns} x {@code rows} nodes, 2 mm apart, held together by rigid links (straight and
     * slanted, so that nodes share links), with dashpots, pressure from below, a swinging rim of attachments, held
     * corners, contractile springs and a moving wall above that presses the upper sheet down.
     */
    public static ParticleSystem sheets(int columns, int rows, int threads) {
        int layer = columns * rows;
        double[] x = new double[6 * layer];
        for (int i = 0; i < 2 * layer; i++) {
            int column = i % layer % columns;
            int row = i % layer / columns;
            x[3 * i] = 3 * column;
            x[3 * i + 1] = 3 * row;
            x[3 * i + 2] = (i < layer ? 0 : 2) + 0.3 * StrictMath.sin(0.7 * column) * StrictMath.cos(0.5 * row);
        }
        NodeLayout layout = NodeLayout.morton(x);
        ParticleSystem system = new ParticleSystem(layout, x, masses(2 * layer, 0.1), Workers.of(threads));
        system.setViscosity(0.02);
        int[] triangles = sheetTriangles(columns, rows);
        int[] upper = Arrays.stream(triangles).map(i -> i + layer).toArray();
        int[][] lowerEdges = edgesOf(triangles);
        int[][] upperEdges = edgesOf(upper);
        double[] share = new double[upperEdges[0].length];
        Arrays.setAll(share, e -> upperEdges[1][e] - upperEdges[0][e] == 1 ? 1 : 0);
        Springs contractile = Springs.between(layout, upperEdges[0], upperEdges[1])
                .stiffness(15)
                .restLengthsAt(x)
                .contractileShares(share)
                .build();
        contractile.setActivation(0.05);
        system.add(contractile);
        system.add(Springs.between(layout, lowerEdges[0], lowerEdges[1])
                .stiffness(15)
                .restLengthsAt(x)
                .damping(0.02)
                .build());
        FacePressure pressure = new FacePressure(layout, triangles, masses(triangles.length / 3, 1));
        pressure.setPressure(-0.01);
        system.add(pressure);
        addRimAndLinks(system, columns, rows, x);
        return system;
    }

    private static void addRimAndLinks(ParticleSystem system, int columns, int rows, double[] x) {
        int layer = columns * rows;
        int[] rim = new int[columns];
        double[] anchors = new double[3 * columns];
        for (int c = 0; c < columns; c++) {
            rim[c] = c;
            System.arraycopy(x, 3 * c, anchors, 3 * c, 3);
        }
        system.add(new Attachments(
                system.layout(), rim, masses(columns, 5), 0.001, SampleMotions.swinging(anchors, 2, 0.5, 6)));
        int last = layer - 1;
        double[] held = {
            x[3 * last], x[3 * last + 1], x[3 * last + 2], x[3 * last - 3], x[3 * last - 2], x[3 * last - 1]
        };
        system.prescribe(new int[] {last, last - 1}, SampleMotions.swinging(held, 1, 0.2, 9));
        int[] a = new int[layer - 1];
        int[] b = new int[layer - 1];
        for (int i = 0; i < layer - 1; i++) {
            a[i] = i;
            b[i] = layer + (i % 7 == 0 ? i + 1 : i);
        }
        system.add(RigidLinks.gaussSeidel(system.layout(), a, b, x, 1e-9, 100));
        int[] top = new int[layer];
        Arrays.setAll(top, i -> layer + i);
        system.add(new SlidingContact(system.layout(), top, new Ceiling(2.2, -2), 0.03));
    }

    /** Two triangles a cell of a grid of nodes, anticlockwise seen from above. */
    public static int[] sheetTriangles(int columns, int rows) {
        int[] triangles = new int[6 * (columns - 1) * (rows - 1)];
        int at = 0;
        for (int row = 0; row < rows - 1; row++) {
            for (int column = 0; column < columns - 1; column++) {
                int i = row * columns + column;
                int[] two = {i, i + 1, i + columns + 1, i, i + columns + 1, i + columns};
                System.arraycopy(two, 0, triangles, at, 6);
                at += 6;
            }
        }
        return triangles;
    }

    /** A level wall above, moving up at a speed: z may not pass height + speed t. */
    public static final class Ceiling implements ContactSurface {
        private final double height;
        private final double speed;
        private double now;
        private int asked;

        public Ceiling(double height, double speed) {
            this.height = height;
            this.speed = speed;
        }

        @Override
        public void prepare(double time) {
            now = time;
            asked++;
        }

        /** How often planes were taken anew. */
        public int asked() {
            return asked;
        }

        @Override
        public void tangentPlane(int node, double x, double y, double z, double[] plane, int at) {
            plane[at] = 0;
            plane[at + 1] = 0;
            plane[at + 2] = -1;
            plane[at + 3] = -(height + speed * now);
            plane[at + 4] = -speed;
        }
    }
}
