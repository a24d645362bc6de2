package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Spring kernels give the bits of the formula written one edge at a time, on any number of threads. */
class SpringKernelTest {
    /** 40 x 40 nodes: several blocks, and calls that are not full. */
    private static final int SIDE = 40;

    private static final int STEPS = 20;
    private static final double ACTIVATION = 0.3;
    private static final double DAMPING = 0.02;

    /** A kind of springs. */
    enum Springiness {
        PLAIN,
        EACH_ITS_OWN,
        CONTRACTILE,
        DASHPOTS,
        DASHPOTS_AND_EACH_ITS_OWN,
        DASHPOTS_AND_CONTRACTILE;

        boolean isContractile() {
            return name().endsWith("CONTRACTILE");
        }

        boolean hasDashpots() {
            return name().startsWith("DASHPOTS");
        }

        boolean isUniform() {
            return this == PLAIN || this == DASHPOTS;
        }
    }

    private final Random random = new Random(7);
    private final double[] x = new double[3 * SIDE * SIDE];
    private final NodeLayout layout;
    private final int[] a;
    private final int[] b;
    private final double[] perEdge;

    SpringKernelTest() {
        Arrays.setAll(x, i -> (i % 3 == 0 ? i / 3 % SIDE : i % 3 == 1 ? i / 3 / SIDE : 0) + 0.3 * random.nextDouble());
        int[] ends = IntStream.range(0, SIDE * (SIDE - 1))
                .flatMap(i -> i % SIDE < SIDE - 1
                        ? IntStream.of(i, i + SIDE, i, i + 1, i + 1, i + SIDE)
                        : IntStream.of(i, i + SIDE))
                .toArray();
        a = IntStream.range(0, ends.length / 2).map(e -> ends[2 * e]).toArray();
        b = IntStream.range(0, ends.length / 2).map(e -> ends[2 * e + 1]).toArray();
        layout = NodeLayout.morton(x);
        perEdge = random.doubles(a.length, 5, 20).toArray();
    }

    private double[] shares() {
        return Arrays.stream(perEdge).map(k -> k / 20).toArray();
    }

    private Springs springs(Springiness kind) {
        Springs.Builder builder = Springs.between(layout, a, b).restLengthsAt(x);
        builder = kind.isUniform() ? builder.stiffness(15) : builder.stiffness(perEdge);
        if (kind.isContractile()) {
            builder.contractileShares(shares());
        }
        Springs springs = builder.damping(kind.hasDashpots() ? DAMPING : 0).build();
        springs.setActivation(ACTIVATION);
        return springs;
    }

    private int hashAfterSteps(Springiness kind, int threads) {
        double[] mass = new double[SIDE * SIDE];
        Arrays.fill(mass, 0.1);
        try (Workers workers = Workers.of(threads)) {
            ParticleSystem system = new ParticleSystem(layout, x, mass, workers);
            system.add(springs(kind));
            double[] v = system.velocities();
            Random speeds = new Random(8);
            Arrays.setAll(v, i -> speeds.nextGaussian());
            Integrator integrator = IntegratorKind.VERLET.create(system);
            for (int i = 0; i < STEPS; i++) {
                integrator.step(0.01 * i, 0.01);
            }
            return 31 * Arrays.hashCode(system.positions()) + Arrays.hashCode(v);
        }
    }

    @ParameterizedTest
    @EnumSource
    void threadsDoNotChangeTheBits(Springiness kind) {
        int one = hashAfterSteps(kind, 1);
        assertThat(hashAfterSteps(kind, 2)).isEqualTo(one);
        assertThat(hashAfterSteps(kind, 3)).isEqualTo(one);
    }

    /** One spring at a time, so that nothing is summed: each end has the bits of the formula. */
    @ParameterizedTest
    @EnumSource
    void eachSpringHasTheBitsOfTheFormula(Springiness kind) {
        Random speeds = new Random(9);
        double[] v = layout.toInternal(IntStream.range(0, x.length)
                .mapToDouble(i -> speeds.nextGaussian())
                .toArray());
        double[] position = layout.toInternal(x);
        Arrays.setAll(position, i -> position[i] + 0.1 * speeds.nextDouble());
        double[] rest = springs(kind).restLengths();
        double c = kind.hasDashpots() ? DAMPING : 0;
        for (int e = 0; e < a.length; e += 17) {
            double k = kind.isUniform() ? 15 : perEdge[e];
            Springs.Builder builder = Springs.between(layout, new int[] {a[e]}, new int[] {b[e]})
                    .stiffness(k)
                    .restLengths(new double[] {rest[e]})
                    .damping(c);
            if (kind.isContractile()) {
                builder.contractileShares(new double[] {shares()[e]});
            }
            Springs one = builder.build();
            one.setActivation(ACTIVATION);
            double[] force = new double[x.length];
            for (int block = 0; block < layout.blockCount(); block++) {
                one.addForces(position, v, force, block);
            }
            double length = kind.isContractile() ? rest[e] - ACTIVATION * (shares()[e] * rest[e]) : rest[e];
            double[] expected = new double[x.length];
            addFormula(position, v, expected, e, new double[] {k, length, c});
            assertThat(force).as("%s, spring %d", kind, e).isEqualTo(expected);
        }
    }

    private void addFormula(double[] p, double[] v, double[] force, int e, double[] constants) {
        int from = 3 * layout.internal(a[e]);
        int to = 3 * layout.internal(b[e]);
        double squared = 0;
        double along = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = p[to + axis] - p[from + axis];
            squared += d * d;
            along += (v[to + axis] - v[from + axis]) * d;
        }
        double q = 1 / Math.sqrt(squared);
        double elastic = constants[0] * (1 - constants[1] * q);
        double tension = constants[2] == 0 ? elastic : elastic + constants[2] * (along * (q * q));
        for (int axis = 0; axis < 3; axis++) {
            double f = (p[to + axis] - p[from + axis]) * tension;
            force[from + axis] += f;
            force[to + axis] -= f;
        }
    }

    /** Stars, single edges and edges between blocks together: the sum over all springs to rounding. */
    @Test
    void allSpringsTogetherAreTheSumOfEach() {
        double[] position = layout.toInternal(x);
        double[] moved = position.clone();
        Arrays.setAll(moved, i -> position[i] + 0.1 * random.nextDouble());
        double[] v = new double[x.length];
        Springs all = springs(Springiness.EACH_ITS_OWN);
        double[] force = new double[x.length];
        for (int block = 0; block < layout.blockCount(); block++) {
            all.addForces(moved, v, force, block);
        }
        double[] expected = new double[x.length];
        for (int e = 0; e < a.length; e++) {
            addFormula(moved, v, expected, e, new double[] {perEdge[e], all.restLengths()[e], 0});
        }
        for (int i = 0; i < force.length; i++) {
            assertThat(force[i]).isCloseTo(expected[i], org.assertj.core.data.Offset.offset(1e-10));
        }
    }
}
