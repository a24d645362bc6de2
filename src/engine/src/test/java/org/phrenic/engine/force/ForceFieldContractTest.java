package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleMotions;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * What holds for every field: force is minus the slope of the energy, K minus the slope of the force, row sums bound K.
 */
class ForceFieldContractTest {
    /** Central differences of step 1e-5 mm on energies of some 1,000 µJ. */
    private static final double SLOPE = 2e-5;

    private static final double ROUNDING = 1e-12;
    private static final int N = 27;
    private static final NodeLayout LAYOUT = NodeLayout.morton(SampleSystems.gridPositions(3, 0, 1));

    private static Springs.Builder springs() {
        int[][] edges = SampleSystems.gridEdges(3);
        double[] k = new Random(2).doubles(edges[0].length, 1, 20).toArray();
        return Springs.between(LAYOUT, edges[0], edges[1]).stiffness(k);
    }

    private static Springs contractile() {
        int[][] edges = SampleSystems.gridEdges(3);
        Springs springs = springs()
                .restLengthsAt(SampleSystems.gridPositions(3, 0, 1))
                .contractileShares(new Random(4).doubles(edges[0].length, 0, 1).toArray())
                .build();
        springs.setActivation(0.4);
        return springs;
    }

    private static Attachments attachments() {
        int[] nodes = {3, 0, 26, 11};
        double[] anchors = new Random(8).doubles(12, -5, 25).toArray();
        Attachments attachments = new Attachments(
                LAYOUT, nodes, new double[] {1, 2, 3, 4}, 0.1, SampleMotions.swinging(anchors, 1, 3, 5));
        attachments.setStiffnessFactor(1.5);
        attachments.prepare(0.37);
        return attachments;
    }

    /** All springs stretched, so that nothing of K is left out. */
    private static Springs stretched() {
        double[] shorter = SampleSystems.gridPositions(3, 0, 1);
        Arrays.setAll(shorter, i -> 0.5 * shorter[i]);
        return springs().restLengthsAt(shorter).build();
    }

    /** Rest lengths below zero: K is larger across the springs than along them. */
    private static Springs overstretched() {
        int count = SampleSystems.gridEdges(3)[0].length;
        double[] k = new Random(2).doubles(count, 1, 20).toArray();
        double[] rest = new Random(3).doubles(count, -40, -10).toArray();
        Springs springs = stretched();
        springs.setCoefficients(k, rest, null);
        return springs;
    }

    private static HingeBending bending() {
        int[] nodes = {0, 1, 3, 10, 4, 13, 12, 26};
        double[] rest = SampleSystems.gridPositions(3, 0, 1);
        return new HingeBending(LAYOUT, Hinges.of(rest, nodes, new double[] {40, 70}), rest);
    }

    private static HingeBending scaledBending() {
        HingeBending field = bending();
        field.keepForcesAt(new Random(9).doubles(3 * N, -2, 2).toArray());
        field.setScale(2.5);
        return field;
    }

    static Stream<Arguments> fieldsWithEnergy() {
        return Stream.of(
                Arguments.of("springs", (Supplier<ForceField>) () -> springs()
                        .restLengthsAt(SampleSystems.gridPositions(3, 0, 1))
                        .build()),
                Arguments.of("contractile springs", (Supplier<ForceField>) ForceFieldContractTest::contractile),
                Arguments.of("attachments", (Supplier<ForceField>) ForceFieldContractTest::attachments),
                Arguments.of("bending", (Supplier<ForceField>) ForceFieldContractTest::bending),
                Arguments.of("scaled bending", (Supplier<ForceField>) ForceFieldContractTest::scaledBending),
                Arguments.of("constant load", (Supplier<ForceField>) () -> new ConstantLoad(
                        LAYOUT, new Random(6).doubles(3 * N, -4, 4).toArray())));
    }

    static Stream<Arguments> fieldsWithWholeStiffness() {
        return Stream.of(
                Arguments.of("stretched springs", (Supplier<ForceField>) ForceFieldContractTest::stretched),
                Arguments.of("springs of negative rest length", (Supplier<ForceField>)
                        ForceFieldContractTest::overstretched),
                Arguments.of("bending", (Supplier<ForceField>) ForceFieldContractTest::bending),
                Arguments.of("attachments", (Supplier<ForceField>) ForceFieldContractTest::attachments));
    }

    static Stream<Arguments> fieldsWithStiffness() {
        // Springs pressed to half their length: what K would lose there is left out.
        double[] longer = SampleSystems.gridPositions(3, 0, 1);
        Arrays.setAll(longer, i -> 2 * longer[i]);
        Arguments pressed = Arguments.of("pressed springs", (Supplier<ForceField>)
                () -> springs().restLengthsAt(longer).build());
        return Stream.concat(Stream.of(pressed), Stream.concat(fieldsWithEnergy(), fieldsWithWholeStiffness()));
    }

    private static double[] state() {
        return LAYOUT.toInternal(SampleSystems.gridPositions(3, 1.5, 7));
    }

    private static double[] forces(ForceField field, double[] x) {
        double[] force = new double[x.length];
        for (int block = 0; block < LAYOUT.blockCount(); block++) {
            field.addForces(x, new double[x.length], force, block);
        }
        return force;
    }

    private static double[] stiffness(ForceField field, double[] x, double[] u) {
        double[] out = new double[x.length];
        for (int block = 0; block < LAYOUT.blockCount(); block++) {
            field.addStiffness(x, u, out, block);
        }
        return out;
    }

    private static double[] moved(double[] x, int i, double by) {
        double[] out = x.clone();
        out[i] += by;
        return out;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("fieldsWithEnergy")
    void forceIsMinusTheSlopeOfTheEnergy(String name, Supplier<ForceField> make) {
        ForceField field = make.get();
        double[] x = state();
        // The dashpots of a field store nothing: they are left out by moving with the anchors.
        double[] still = forces(field, x);
        if (field.dependsOnVelocity()) {
            double[] v = new double[x.length];
            double speed = 3 * 5 * StrictMath.cos(5 * 0.37);
            for (int i = 1; i < v.length; i += 3) {
                v[i] = speed;
            }
            Arrays.fill(still, 0);
            field.addForces(x, v, still, 0);
        }
        double e = 1e-5;
        for (int i = 0; i < x.length; i++) {
            double slope = (field.potentialEnergy(moved(x, i, e)) - field.potentialEnergy(moved(x, i, -e))) / (2 * e);
            assertThat(still[i]).isCloseTo(-slope, within(SLOPE));
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("fieldsWithWholeStiffness")
    void stiffnessIsMinusTheSlopeOfTheForce(String name, Supplier<ForceField> make) {
        ForceField field = make.get();
        double[] x = state();
        double e = 1e-5;
        for (int j = 0; j < x.length; j++) {
            double[] unit = new double[x.length];
            unit[j] = 1;
            double[] column = stiffness(field, x, unit);
            double[] ahead = forces(field, moved(x, j, e));
            double[] behind = forces(field, moved(x, j, -e));
            for (int i = 0; i < x.length; i++) {
                assertThat(column[i]).isCloseTo((behind[i] - ahead[i]) / (2 * e), within(SLOPE));
            }
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("fieldsWithStiffness")
    void stiffnessIsSymmetricPositiveAndBoundedByItsRowSums(String name, Supplier<ForceField> make) {
        ForceField field = make.get();
        double[] x = state();
        double[] rowSum = new double[N];
        field.addRowSums(x, rowSum, new double[N]);
        Random random = new Random(9);
        for (int trial = 0; trial < 20; trial++) {
            double[] u = random.doubles(x.length, -1, 1).toArray();
            double[] w = random.doubles(x.length, -1, 1).toArray();
            double[] ku = stiffness(field, x, u);
            assertThat(dot(w, ku)).isCloseTo(dot(u, stiffness(field, x, w)), within(1e-9));
            assertThat(dot(u, ku)).isGreaterThanOrEqualTo(-1e-9);
        }
        // Sum of the norms of the 3 x 3 blocks of a row, each found from its columns (Frobenius, so an upper bound for
        // blocks of rank 1, and the spectral norm times at most √3 else).
        for (int n = 0; n < N; n++) {
            double[] block = new double[N];
            for (int axis = 0; axis < 3; axis++) {
                double[] unit = new double[x.length];
                unit[3 * n + axis] = 1;
                double[] column = stiffness(field, x, unit);
                for (int i = 0; i < x.length; i++) {
                    block[i / 3] += column[i] * column[i];
                }
            }
            double diagonal = Math.sqrt(block[n]) / Math.sqrt(3);
            double others = 0;
            for (int i = 0; i < N; i++) {
                others += i == n ? 0 : Math.sqrt(block[i]) / Math.sqrt(3);
            }
            assertThat(diagonal + others).isLessThanOrEqualTo(rowSum[n] + 1e-9);
        }
    }

    private static double dot(double[] a, double[] b) {
        return IntStream.range(0, a.length).mapToDouble(i -> a[i] * b[i]).sum();
    }

    /** Blocks and threads are an inner matter: forces on many blocks are those on one. */
    @Test
    void blocksDoNotShowInTheForces() {
        ParticleSystem many = SampleSystems.sheets(40, 30, 1);
        assertThat(many.layout().blockCount()).isGreaterThan(3);
        double[] v = new Random(3).doubles(7200, -1, 1).toArray();
        double[] force = new double[7200];
        many.forces(0.1, many.positions(), v, force);
        double[] one = new double[7200];
        for (ForceField field : many.fields()) {
            for (int block = many.layout().blockCount() - 1; block >= 0; block--) {
                double[] part = new double[7200];
                field.addForces(many.positions(), v, part, block);
                for (int i = 0; i < part.length; i++) {
                    boolean inside = many.layout().blockOf(i / 3) == block;
                    assertThat(inside || part[i] == 0)
                            .as("a block's own nodes only")
                            .isTrue();
                    one[i] += part[i];
                }
            }
        }
        for (int i = 0; i < 7200; i++) {
            assertThat(force[i]).isCloseTo(one[i], within(ROUNDING));
        }
    }

    @Test
    void switchedOffFieldIsNotCalled() {
        int[] calls = new int[1];
        ForceField counting = new ForceField() {
            @Override
            public void prepare(double time) {
                calls[0]++;
            }

            @Override
            public void addForces(double[] x, double[] v, double[] force, int block) {
                calls[0]++;
                force[0] += 1;
            }

            @Override
            public double potentialEnergy(double[] x) {
                calls[0]++;
                return 7;
            }
        };
        ParticleSystem system =
                new ParticleSystem(LAYOUT, new double[3 * N], SampleSystems.masses(N, 1), Workers.of(1));
        system.add(counting);
        double[] force = new double[3 * N];
        system.forces(0, system.positions(), system.velocities(), force);
        assertThat(calls[0]).isEqualTo(2);
        assertThat(force[0]).isEqualTo(1);
        assertThat(system.potentialEnergy()).isEqualTo(7);
        system.setEnabled(counting, false);
        calls[0] = 0;
        system.forces(0, system.positions(), system.velocities(), force);
        assertThat(calls[0]).isZero();
        assertThat(force[0]).isZero();
        assertThat(system.potentialEnergy()).isZero();
        assertThat(system.fields()).isEmpty();
        system.setEnabled(counting, true);
        system.forces(0, system.positions(), system.velocities(), force);
        assertThat(force[0]).isEqualTo(1);
    }

    @Test
    void refusesWhatCannotBe() {
        int[] a = {0, 1};
        int[] b = {1, 2};
        double[] x = SampleSystems.gridPositions(3, 0, 1);
        for (double bad : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            String found = "found " + bad;
            refused(
                    () -> Springs.between(LAYOUT, a, b)
                            .stiffness(bad)
                            .restLengthsAt(x)
                            .build(),
                    "stiffness of spring 0",
                    found);
            refused(
                    () -> Springs.between(LAYOUT, a, b)
                            .stiffness(1)
                            .restLengths(new double[] {1, bad})
                            .build(),
                    "rest length of spring 1",
                    found);
            refused(
                    () -> Springs.between(LAYOUT, a, b)
                            .stiffness(1)
                            .restLengthsAt(x)
                            .damping(bad)
                            .build(),
                    "damping of springs",
                    found);
            refused(
                    () -> Springs.between(LAYOUT, a, b)
                            .stiffness(1)
                            .restLengthsAt(x)
                            .contractileShares(new double[] {0, bad})
                            .build(),
                    "contractile share of spring 1",
                    found);
            refused(
                    () -> new Attachments(
                            LAYOUT,
                            new int[] {0},
                            new double[] {bad},
                            0,
                            SampleMotions.swinging(new double[3], 0, 1, 1)),
                    "stiffness of attachment 0",
                    found);
            refused(
                    () -> new Attachments(
                            LAYOUT,
                            new int[] {0},
                            new double[] {1},
                            bad,
                            SampleMotions.swinging(new double[3], 0, 1, 1)),
                    "damping of attachments",
                    found);
        }
        refused(
                () -> Springs.between(LAYOUT, a, b).restLengthsAt(x).build(),
                "stiffness of springs: found none",
                "expected 2");
        refused(
                () -> Springs.between(LAYOUT, a, new int[] {1, 1})
                        .stiffness(1)
                        .restLengths(new double[2])
                        .build(),
                "edge 1",
                "node 1");
        refused(
                () -> Springs.between(LAYOUT, a, b).stiffness(1).restLengthsAt(new double[81]),
                "spring 0 between nodes 0 and 1",
                "found length 0.0 mm");
        refused(() -> new ActionLine(LAYOUT, a, x, 0, 0, 0), "radius of an action line", "found 0.0 mm");
        refused(() -> new FacePressure(LAYOUT, new int[] {0, 1, 2}, new double[2]), "3 corners", "2 weights");
        refused(() -> new ConstantLoad(LAYOUT, new double[2]), "load: found 2", "expected 81");
    }

    private static void refused(Runnable make, String what, String found) {
        assertThatThrownBy(make::run)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(what)
                .hasMessageContaining(found)
                .hasMessageContaining("expected");
    }
}
