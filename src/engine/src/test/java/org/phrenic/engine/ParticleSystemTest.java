package org.phrenic.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Nodes, their order in memory, and what is refused of them. */
class ParticleSystemTest {
    private static final double ROUNDING = 1e-12;

    private static ParticleSystem system(double[] x, double... mass) {
        return new ParticleSystem(NodeLayout.morton(x), x, mass, Workers.of(1));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 511, 768, 1700, 5000})
    void layoutIsAPermutationInBlocksWithoutGaps(int n) {
        double[] x = new Random(n).doubles(3L * n, -80, 120).toArray();
        for (NodeLayout layout : new NodeLayout[] {NodeLayout.morton(x), NodeLayout.natural(n)}) {
            assertThat(layout.nodeCount()).isEqualTo(n);
            assertThat(IntStream.range(0, n).map(layout::internal).sorted().toArray())
                    .isEqualTo(IntStream.range(0, n).toArray());
            int next = 0;
            for (int block = 0; block < layout.blockCount(); block++) {
                assertThat(layout.start(block)).isEqualTo(next);
                next = layout.end(block);
                for (int i = layout.start(block); i < next; i++) {
                    assertThat(layout.blockOf(i)).isEqualTo(block);
                    assertThat(layout.internal(layout.caller(i))).isEqualTo(i);
                }
            }
            assertThat(next).isEqualTo(n);
            double[] back = new double[3 * n];
            layout.toCaller(layout.toInternal(x), back);
            assertThat(back).isEqualTo(x);
        }
    }

    /**
     * Neighbours in space are neighbours in memory: the mean jump along memory is far below that of the order given.
     */
    @Test
    void mortonOrderKeepsNeighboursTogether() {
        double[] x = new Random(1).doubles(15_000, 0, 100).toArray();
        double[] sorted = NodeLayout.morton(x).toInternal(x);
        assertThat(meanJump(sorted)).isLessThan(0.2 * meanJump(x));
    }

    private static double meanJump(double[] x) {
        double sum = 0;
        for (int i = 3; i < x.length; i += 3) {
            sum += Math.hypot(x[i] - x[i - 3], Math.hypot(x[i + 1] - x[i - 2], x[i + 2] - x[i - 1]));
        }
        return sum / (x.length / 3.0 - 1);
    }

    /** The order in memory is an inner matter: a scene whose nodes are numbered backwards moves alike. */
    @Test
    void numberingOfNodesDoesNotMatter() {
        int n = 1500;
        double[] x = new Random(4).doubles(3 * n, 0, 50).toArray();
        double[] load = new Random(5).doubles(3 * n, -1, 1).toArray();
        double[] mass = new Random(6).doubles(n, 0.1, 0.3).toArray();
        double[] out = new double[3];
        double[] back = new double[3];
        ParticleSystem forward = system(x, mass);
        ParticleSystem backward = system(reversed(x, 3), reversed(mass, 1));
        forward.add(new ConstantLoad(forward.layout(), load));
        backward.add(new ConstantLoad(backward.layout(), reversed(load, 3)));
        forward.fix(3, 800);
        backward.fix(n - 1 - 3, n - 1 - 800);
        IntegratorKind.VERLET.create(forward).step(0, 0.1);
        IntegratorKind.VERLET.create(backward).step(0, 0.1);
        for (int i = 0; i < n; i++) {
            forward.position(i, out);
            backward.position(n - 1 - i, back);
            assertThat(back).isEqualTo(out);
            boolean held = i == 3 || i == 800;
            for (int axis = 0; axis < 3; axis++) {
                double way = held ? 0 : 0.5 * 0.01 * load[3 * i + axis] / mass[i];
                assertThat(out[axis]).isCloseTo(x[3 * i + axis] + way, within(ROUNDING * 50));
            }
        }
        assertThat(backward.kineticEnergy()).isCloseTo(forward.kineticEnergy(), within(ROUNDING));
    }

    private static double[] reversed(double[] values, int width) {
        double[] out = new double[values.length];
        for (int i = 0; i < values.length / width; i++) {
            System.arraycopy(values, width * i, out, values.length - width * (i + 1), width);
        }
        return out;
    }

    @Test
    void nodesThatAreLetGoMoveAgain() {
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 4);
        system.fix(0);
        assertThat(system.inverseMasses()).containsExactly(0, 0.25);
        system.fix(1);
        assertThat(system.inverseMasses()).containsExactly(1, 0);
        system.fix();
        assertThat(system.inverseMasses()).containsExactly(1, 0.25);
    }

    @Test
    void viscosityIsOneForAllOrInProportionToMass() {
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 4);
        system.setViscosity(0.02);
        assertThat(system.viscosities()).containsOnly(0.02);
        system.setViscosityPerMass(3);
        assertThat(system.viscosities()).containsExactly(3, 12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY})
    void refusesNumbersThatCannotBe(double bad) {
        double[] x = {0, 0, 0, 5, 0, 0};
        assertThatThrownBy(() -> system(x, 1, bad))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("mass of node 1: found " + bad + " kg, expected more than 0");
        ParticleSystem system = system(x, 1, 1);
        assertThatThrownBy(() -> system.setViscosity(bad))
                .hasMessage("viscosity: found " + bad + " N s/m, expected 0 or more");
        assertThatThrownBy(() -> system.setViscosityPerMass(bad)).hasMessageContaining("found " + bad + " 1/s");
        if (bad != -1) {
            double[] lost = x.clone();
            lost[4] = bad;
            assertThatThrownBy(() -> system(lost, 1, 1)).hasMessageContaining("position of node 1: found " + bad);
        }
    }

    @Test
    void refusesNumbersOfNodesThatDiffer() {
        assertThatThrownBy(
                        () -> new ParticleSystem(NodeLayout.natural(2), new double[6], new double[] {1}, Workers.of(1)))
                .hasMessage("found 6 coordinates and 1 masses, expected 6 and 2");
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 1);
        assertThatThrownBy(() -> system.prescribe(new int[] {0, 1}, PrescribedMotion.stationary(new double[3])))
                .hasMessage("found 2 nodes and 1 prescribed points, expected as many");
        assertThat(Arrays.stream(system.inverseMasses())).containsOnly(1.0);
    }

    /** A call that is refused leaves everything as it was: what was fixed does not fall. */
    @Test
    void fixedNodesStayFixedWhereAMotionIsRefused() {
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 4);
        system.fix(0, 1);
        PrescribedMotion ofTwo = PrescribedMotion.stationary(new double[6]);
        assertThatThrownBy(() -> system.prescribe(new int[] {1}, ofTwo))
                .hasMessage("found 1 nodes and 2 prescribed points, expected as many");
        assertThatThrownBy(() -> system.prescribe(new int[] {1, 2}, ofTwo))
                .isInstanceOf(IndexOutOfBoundsException.class);
        assertThat(system.inverseMasses()).containsExactly(0, 0);
        system.fix(1);
        assertThat(system.inverseMasses()).containsExactly(1, 0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void aMassThatCannotBeIsRefusedAndChangesNothing(double bad) {
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 4);
        system.fix(1);
        for (int node : new int[] {0, 1}) {
            assertThatThrownBy(() -> system.setMass(node, bad))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("mass of node " + node + ": found " + bad + " kg, expected more than 0");
        }
        assertThat(system.masses()).containsExactly(1, 4);
        system.setMass(0, 2);
        system.setMass(1, 8);
        assertThat(system.inverseMasses()).containsExactly(0.5, 0);
        system.fix();
        assertThat(system.inverseMasses()).containsExactly(0.5, 0.125);
    }

    /** Its force or its correction would count twice. */
    @Test
    void aFieldOrConstraintIsAddedOnceAndSwitchedOnlyThen() {
        ParticleSystem system = system(new double[] {0, 0, 0, 5, 0, 0}, 1, 1);
        ConstantLoad load = new ConstantLoad(system.layout(), new double[] {0, 0, -1, 0, 0, 0});
        RigidLinks link =
                RigidLinks.singlePass(system.layout(), new int[] {0}, new int[] {1}, new double[] {0, 0, 0, 5, 0, 0});
        assertThatThrownBy(() -> system.setEnabled(load, true)).hasMessageContaining("never added");
        assertThatThrownBy(() -> system.setEnabled(link, true)).hasMessageContaining("never added");
        system.add(load);
        system.add(link);
        system.setEnabled(load, false);
        assertThatThrownBy(() -> system.add(load))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("force field: found one that was added before, expected a new one");
        assertThatThrownBy(() -> system.add(link))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("constraint: found one that was added before, expected a new one");
        assertThat(system.fields()).isEmpty();
        assertThat(system.constraints()).containsExactly(link);
    }
}
