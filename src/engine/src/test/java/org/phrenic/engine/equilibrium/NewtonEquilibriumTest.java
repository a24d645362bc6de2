package org.phrenic.engine.equilibrium;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

class NewtonEquilibriumTest {
    private static final double TOLERANCE_MN = 1e-9;
    private static final int SIDE = 13;

    private static boolean[] all(ParticleSystem system) {
        boolean[] may = new boolean[system.nodeCount()];
        Arrays.fill(may, true);
        return may;
    }

    /**
     * 50 mN against a spring of 5 N/m: 10 mm, or where a ceiling is in between. Begun on the ceiling, it lets go where
     * the load pulls away.
     */
    @ParameterizedTest
    @CsvSource({"50, 20, 10, 0", "50, 4, 4, 1", "-50, 0, -10, 0"})
    void aNodeComesToRestWhereItsForcesBalanceOrAtTheWall(double load, double ceiling, double rest, int binding) {
        ParticleSystem system = SampleSystems.oscillator(0.1, 5, 0);
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, load}));
        system.add(new SlidingContact(system.layout(), new int[] {0}, new SampleSystems.Ceiling(ceiling, 0), 0.01));
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 0, all(system)).findEquilibrium(TOLERANCE_MN, 10);
        assertThat(result.activeSetSettled()).isTrue();
        assertThat(system.positions()[2]).isCloseTo(rest, within(1e-9));
        assertThat(result.activeRows()).isEqualTo(binding);
    }

    /**
     * A load on a rigid link comes to rest in line with it; of order 2 only if the link's turning is in the derivative.
     */
    @Test
    void aLinkTurnsIntoItsLoad() {
        double[] x = {0, 0, 0, 8, 1, -6};
        ParticleSystem system =
                new ParticleSystem(NodeLayout.natural(2), x, SampleSystems.masses(2, 0.1), Workers.of(1));
        system.prescribe(new int[] {0}, PrescribedMotion.stationary(new double[3]));
        system.add(RigidLinks.gaussSeidelToLengths(
                system.layout(), new int[] {0}, new int[] {1}, new double[] {10}, 1e-12, 10));
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, 0, 3, 0, -4}));
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 0, all(system)).findEquilibrium(TOLERANCE_MN, 10);
        assertThat(result.activeSetSettled()).isTrue();
        assertThat(Arrays.copyOfRange(system.positions(), 3, 6))
                .usingComparatorWithPrecision(1e-8)
                .containsExactly(6, 0, -8);
        assertThat(result.residualsMn()).hasSizeLessThan(7);
    }

    /** A sheet held at its border, pressed by follower pressure against a ceiling. */
    private static ParticleSystem pressed(double ceiling) {
        double[] x = new double[3 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            x[3 * i] = 3 * (i % SIDE);
            x[3 * i + 1] = 3 * (i / SIDE);
        }
        NodeLayout layout = NodeLayout.morton(x);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(SIDE * SIDE, 0.01), Workers.of(1));
        int[] triangles = SampleSystems.sheetTriangles(SIDE, SIDE);
        int[][] edges = SampleSystems.edgesOf(triangles);
        double[] length = new double[edges[0].length];
        for (int e = 0; e < length.length; e++) {
            int a = 3 * edges[0][e];
            int b = 3 * edges[1][e];
            // Stretched by 2 %, so that the flat sheet resists what is across it.
            length[e] = Math.hypot(x[a] - x[b], x[a + 1] - x[b + 1]) / 1.02;
        }
        system.add(Springs.between(layout, edges[0], edges[1])
                .stiffness(15)
                .restLengths(length)
                .build());
        FacePressure pressure = new FacePressure(layout, triangles, SampleSystems.masses(triangles.length / 3, 1));
        pressure.setPressure(-0.05);
        system.add(pressure);
        int[] border = IntStream.range(0, SIDE * SIDE)
                .filter(i -> i % SIDE == 0 || i % SIDE == SIDE - 1 || i / SIDE == 0 || i / SIDE == SIDE - 1)
                .toArray();
        system.fix(border);
        int[] nodes = IntStream.range(0, SIDE * SIDE).toArray();
        system.add(new SlidingContact(layout, nodes, new SampleSystems.Ceiling(ceiling, 0), 0.01));
        return system;
    }

    @Test
    void aPressedSheetComesToRestWhereItsOwnMotionDoesAndOfOrderTwo() {
        ParticleSystem system = pressed(2.5);
        ParticleSystem moving = pressed(2.5);
        moving.setViscosityPerMass(20);
        Integrator integrator = IntegratorKind.VERLET.create(moving);
        for (int i = 0; i < 6000; i++) {
            integrator.step(i * 1e-3, 1e-3);
        }
        // Half a second is not rest, but near enough for what binds.
        system.setViscosityPerMass(20);
        Integrator near = IntegratorKind.VERLET.create(system);
        for (int i = 0; i < 500; i++) {
            near.step(i * 1e-3, 1e-3);
        }
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 0, all(system)).findEquilibrium(TOLERANCE_MN, 30);
        assertThat(result.activeSetSettled()).isTrue();
        assertThat(result.activeRows()).isBetween(10, SIDE * SIDE);
        for (int i = 0; i < system.positions().length; i++) {
            assertThat(system.positions()[i]).isCloseTo(moving.positions()[i], within(1e-6));
        }
    }

    @Test
    void theResidualFallsAsItsSquare() {
        ParticleSystem system = pressed(1e3);
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 0, all(system)).findEquilibrium(TOLERANCE_MN, 1);
        assertThat(result.converged()).isTrue();
        assertThat(result.activeSetSettled()).as("nothing is near the ceiling").isTrue();
        double[] r = result.residualsMn();
        assertThat(r).hasSizeGreaterThan(3);
        int last = r.length - 1;
        // log r falls by twice as much from step to step; what differences of forces leave takes a little off.
        assertThat(Math.log(r[last] / r[last - 1]) / Math.log(r[last - 1] / r[last - 2]))
                .isGreaterThan(1.6);
        assertThat(r[last]).isLessThan(TOLERANCE_MN);
    }

    /** After one round, in which nothing binds, what lies beyond the ceiling is what would have to. */
    @Test
    void whatWouldChangeIsWhatContradictsTheSolution() {
        ParticleSystem system = pressed(2.5);
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 0, all(system)).findEquilibrium(TOLERANCE_MN, 1);
        double[] x = system.positions();
        int beyond = (int)
                IntStream.range(0, SIDE * SIDE).filter(i -> x[3 * i + 2] > 2.5).count();
        assertThat(result.converged()).isTrue();
        assertThat(result.activeSetSettled()).isFalse();
        assertThat(result.activeRows()).isZero();
        assertThat(result.activeSetChanges()).isEqualTo(beyond).isPositive();
    }

    @Test
    void nodesThatMayNotMoveStayToTheBit() {
        ParticleSystem system = pressed(1e3);
        boolean[] may = all(system);
        Arrays.fill(may, 0, SIDE * SIDE / 2, false);
        double[] before = new double[3 * SIDE * SIDE];
        double[] after = new double[3 * SIDE * SIDE];
        system.layout().toCaller(system.positions(), before);
        assertThat(new NewtonEquilibrium(system, 0, may)
                        .findEquilibrium(TOLERANCE_MN, 3)
                        .converged())
                .isTrue();
        system.layout().toCaller(system.positions(), after);
        int half = 3 * (SIDE * SIDE / 2);
        assertThat(Arrays.copyOf(after, half)).isEqualTo(Arrays.copyOf(before, half));
        assertThat(after).isNotEqualTo(before);
    }

    /**
     * Three nodes in a row; the right end leaves at 10 mm/s and is at 40 mm after 2 s, so the middle rests at 20 mm.
     */
    @Test
    void prescribedNodesAreWhereTheyAreAtTheTimeOfTheEquilibrium() {
        double[] x = {0, 0, 0, 10, 0, 0, 20, 0, 0};
        NodeLayout layout = NodeLayout.natural(3);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(3, 0.001), Workers.of(1));
        system.add(Springs.between(layout, new int[] {0, 1}, new int[] {1, 2})
                .stiffness(10)
                .restLengthsAt(x)
                .build());
        system.prescribe(new int[] {0, 2}, new PrescribedMotion() {
            @Override
            public int pointCount() {
                return 2;
            }

            @Override
            public void at(double time, double[] position, double[] velocity) {
                position[3] = 20 + 10 * time;
                velocity[3] = 10;
            }
        });
        NewtonEquilibrium.Result result =
                new NewtonEquilibrium(system, 2, all(system)).findEquilibrium(TOLERANCE_MN, 10);
        assertThat(result.activeSetSettled()).isTrue();
        assertThat(system.positions()).containsExactly(new double[] {0, 0, 0, 20, 0, 0, 40, 0, 0}, within(1e-9));
        assertThat(system.velocities()).containsOnly(0);
    }
}
