package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.SlowMotionRelease;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Nodes apart, which make shorter steps than the others: each part moves as if it were alone. */
class NodesApartTest {
    private static final double MASS = 0.1;
    private static final double GAMMA = 0.02;
    private static final double SOFT = 15;
    private static final double STIFF = 100;
    private static final double DT = 0.01;

    /** Chains of three nodes, the first node of each held by a spring: three soft nodes, then three stiff ones. */
    private static double[] positions() {
        return new double[] {0, 0, 0, 10, 1, 0, 19, 0, 2, 3, 40, 0, 12, 41, 0, 23, 40, 1};
    }

    private static ParticleSystem chains(double[] x, int firstApart, int apart, double... stiffness) {
        int n = x.length / 3;
        NodeLayout layout = NodeLayout.morton(x, firstApart, apart);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(n, MASS), Workers.of(1));
        for (int chain = 0; chain < stiffness.length; chain++) {
            int first = 3 * chain;
            system.add(Springs.between(layout, new int[] {first, first + 1}, new int[] {first + 1, first + 2})
                    .stiffness(stiffness[chain])
                    .restLengths(new double[] {8, 8})
                    .build());
            double[] anchor = Arrays.copyOfRange(x, 3 * first, 3 * first + 3);
            system.add(new Attachments(
                    layout,
                    new int[] {first},
                    new double[] {stiffness[chain]},
                    0,
                    PrescribedMotion.stationary(anchor)));
        }
        system.setViscosity(GAMMA);
        return system;
    }

    private static Stepper stepper(ParticleSystem system, double dt) {
        return new Stepper(IntegratorKind.RK2.create(system), dt, StepPolicy.SUBSTEP);
    }

    /** Positions in the caller's order after so many seconds. */
    private static double[] after(double seconds, Stepper stepper) {
        while (stepper.time() < seconds - 1e-9) {
            stepper.step();
        }
        double[] x = new double[stepper.system().positions().length];
        stepper.system().layout().toCaller(stepper.system().positions(), x);
        return x;
    }

    @Test
    void eachPartMovesAsIfItWereAlone() {
        Stepper both = stepper(chains(positions(), 3, 3, SOFT, STIFF), DT);
        Stepper soft = stepper(chains(Arrays.copyOf(positions(), 9), 0, 0, SOFT), DT);
        Stepper stiff = stepper(chains(Arrays.copyOfRange(positions(), 9, 18), 0, 0, STIFF), DT / both.substeps());
        assertThat(both.substeps()).isEqualTo(soft.substeps());
        assertThat(both.stepsApart()).isEqualTo(stiff.substeps()).isGreaterThan(1);
        double[] x = after(1, both);
        assertThat(Arrays.copyOf(x, 9)).containsExactly(after(1, soft));
        double[] alone = after(1, stiff);
        for (int i = 0; i < 9; i++) {
            // The times of the steps differ by rounding only, and no force here depends on the time.
            assertThat(x[9 + i]).isEqualTo(alone[i]);
        }
    }

    @Test
    void aSchemeThatCannotStepThemApartTakesTheStepsOfTheStiffest() {
        ParticleSystem system = chains(positions(), 3, 3, SOFT, STIFF);
        StabilityLimit limit = StabilityLimit.of(system);
        StabilityLimit whole = StabilityLimit.of(chains(positions(), 0, 0, SOFT, STIFF));
        assertThat(limit.largestStep(IntegratorKind.VERLET))
                .isCloseTo(whole.largestStep(IntegratorKind.VERLET), within(1e-12));
        assertThat(limit.isStable(IntegratorKind.VERLET, whole.largestStep(IntegratorKind.VERLET) * 1.01))
                .isFalse();
        assertThat(limit.stepsApart(IntegratorKind.VERLET, DT, Stepper.SAFETY)).isEqualTo(1);
        assertThatThrownBy(() -> IntegratorKind.VERLET.create(system).setStepsApart(2))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("verlet");
    }

    /** As the substeps of the others, so that the run goes on as one that never left the state before the change. */
    @Test
    void aReturnToTheStateBeforeAChangeRestoresTheStepsOfNodesApart() {
        ParticleSystem system = chains(positions(), 3, 3, SOFT, STIFF);
        Stepper stepper = stepper(system, DT);
        stepper.step();
        int before = stepper.stepsApart();
        stepper.checkpoint();
        for (int node = 3; node < 6; node++) {
            system.setMass(system.layout().internal(node), MASS / 4);
        }
        stepper.measureStabilityLimit();
        assertThat(stepper.stepsApart()).isGreaterThan(before);
        system.velocities()[0] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(stepper.stepsApart()).isEqualTo(before);
    }

    @Test
    void aRefusedStepIsRefusedForNodesApartToo() {
        ParticleSystem system = chains(positions(), 3, 3, 0.01, STIFF);
        assertThatThrownBy(() -> new Stepper(IntegratorKind.RK2.create(system), DT, StepPolicy.REFUSE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("refused")
                .hasMessageContaining(String.format(
                        Locale.ROOT,
                        "limit %.6g s",
                        StabilityLimit.of(system).apart().orElseThrow().largestStep(IntegratorKind.RK2)));
    }

    @Test
    void nodesApartLieBehindTheOthersInBlocksOfTheirOwn() {
        NodeLayout layout = NodeLayout.morton(SampleSystems.gridPositions(12, 0, 1), 100, 700);
        int first = layout.start(layout.firstBlockApart());
        assertThat(layout.hasNodesApart()).isTrue();
        assertThat(first).isEqualTo(1728 - 700);
        assertThat(layout.end(layout.blockCount() - 1)).isEqualTo(1728);
        for (int node = 0; node < 1728; node++) {
            assertThat(layout.internal(node) >= first).isEqualTo(node >= 100 && node < 800);
            assertThat(layout.caller(layout.internal(node))).isEqualTo(node);
        }
        assertThat(NodeLayout.morton(positions()).hasNodesApart()).isFalse();
    }

    /** Viscosity with and without release: whatever the steps of nodes apart, they are damped alike. */
    @Test
    void nodesApartAreReleasedOfViscosityInSlowMotionAlone() {
        double[] one = energiesReleased(1);
        double[] four = energiesReleased(4);
        double[] scale = energiesReleased(0);
        // The release keeps the error of order 1 of rk2, h r times the energy.
        assertThat(four[0]).isCloseTo(one[0], within(1e-12));
        assertThat(four[1]).isCloseTo(one[1], within(0.01 * one[1]));
        assertThat(one[1]).isLessThan(0.1 * scale[1]);
    }

    /**
     * Energies of two swinging pairs, the second apart, after a second in a scheme that releases slow motion.
     *
     * @param stepsApart 0 for the energies at the beginning
     */
    private static double[] energiesReleased(int stepsApart) {
        double[] x = {0, 0, 0, 11, 0, 0, 100, 0, 0, 111, 0, 0};
        NodeLayout layout = NodeLayout.morton(x, 2, 2);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(4, 0.001), Workers.of(1));
        Springs[] pairs = new Springs[2];
        for (int i = 0; i < 2; i++) {
            pairs[i] = Springs.between(layout, new int[] {2 * i}, new int[] {2 * i + 1})
                    .stiffness(1)
                    .restLengths(new double[] {10})
                    .build();
            system.add(pairs[i]);
        }
        system.setViscosityPerMass(5);
        system.add(new SlowMotionRelease(system, 1));
        double h = 5e-4;
        Integrator integrator = IntegratorKind.RK2.create(system);
        if (stepsApart > 0) {
            integrator.setStepsApart(stepsApart);
        }
        for (int i = 0; stepsApart > 0 && i < 2000; i++) {
            integrator.step(i * h, h);
        }
        double[] energy = new double[2];
        for (int n = 0; n < 4; n++) {
            int i = layout.caller(n) / 2;
            for (int axis = 0; axis < 3; axis++) {
                double v = system.velocities()[3 * n + axis];
                energy[i] += 0.5 * 0.001 * v * v;
            }
        }
        for (int i = 0; i < 2; i++) {
            energy[i] += pairs[i].potentialEnergy(system.positions());
        }
        return energy;
    }

    @ParameterizedTest
    @CsvSource({"3, 4", "-1, 2", "0, 6", "0, -1", "2147483647, 2"})
    void nodesApartThatAreNotAmongTheNodesOrAreAllOfThemAreRefused(int first, int apart) {
        assertThatThrownBy(() -> NodeLayout.morton(positions(), first, apart))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("nodes apart: found " + apart + " from node " + first + " on");
    }
}
