package org.phrenic.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** A group of nodes is translated as if it were lighter and deformed as if it were not. */
class SelectiveMassTest {
    private static final double KG = 0.2;
    private static final double LIGHTNESS = 9;
    /** Each node to its place at rest, N/m. */
    private static final double HELD = 5;
    /** Between the nodes, N/m. */
    private static final double BETWEEN = 40;

    private static final double STEP_S = 1e-5;
    private static final int STEPS = 10_000;
    /** What a scheme of order 1 loses in so many steps. */
    private static final double SLACK = 2e-3;
    /** Nodes 1 and 3 of four are the group, and differ in mass. */
    private static final double[] UNEQUAL_KG = {0.4, 0.2, 0.5, 0.6};

    private static final int[] GROUP = {1, 3};

    /** Two nodes 10 mm apart on a spring at rest, each held to its place. */
    private static ParticleSystem pair(double between, double damping) {
        double[] places = {0, 0, 0, 10, 0, 0};
        ParticleSystem system = new ParticleSystem(NodeLayout.natural(2), places, new double[] {KG, KG}, Workers.of(1));
        system.add(new Attachments(
                system.layout(),
                new int[] {0, 1},
                new double[] {HELD, HELD},
                0,
                PrescribedMotion.stationary(places.clone())));
        system.add(Springs.between(system.layout(), new int[] {0}, new int[] {1})
                .stiffness(between)
                .restLengthsAt(places)
                .build());
        system.setSelectiveMass(new int[] {0, 1}, LIGHTNESS);
        system.setViscosityPerMass(damping);
        return system;
    }

    /** Way of node 1 along the line of both, from 1 mm, after the steps. */
    private static double after(IntegratorKind kind, double firstNode, double damping) {
        ParticleSystem system = pair(BETWEEN, damping);
        double[] x = system.positions();
        x[0] += firstNode;
        x[3] += 1;
        Integrator integrator = kind.create(system);
        for (int i = 0; i < STEPS; i++) {
            integrator.step(i * STEP_S, STEP_S);
        }
        return x[3] - 10;
    }

    @ParameterizedTest
    @EnumSource
    void translationSwingsAsThatOfALighterGroup(IntegratorKind kind) {
        double omega = Math.sqrt(LIGHTNESS * HELD / KG);
        assertThat(after(kind, 1, 0)).isCloseTo(Math.cos(omega * STEPS * STEP_S), within(SLACK));
    }

    @ParameterizedTest
    @EnumSource
    void deformationSwingsAsWithoutAGroup(IntegratorKind kind) {
        double omega = Math.sqrt((HELD + 2 * BETWEEN) / KG);
        assertThat(after(kind, -1, 0)).isCloseTo(Math.cos(omega * STEPS * STEP_S), within(SLACK));
    }

    @ParameterizedTest
    @EnumSource
    void viscosityPerMassDampsBothAtItsRate(IntegratorKind kind) {
        double rate = 6;
        double t = STEPS * STEP_S;
        double[] squares = {LIGHTNESS * HELD / KG, (HELD + 2 * BETWEEN) / KG};
        for (int mode = 0; mode < 2; mode++) {
            double omega = Math.sqrt(squares[mode] - rate * rate / 4);
            double expected =
                    Math.exp(-rate * t / 2) * (Math.cos(omega * t) + rate / (2 * omega) * Math.sin(omega * t));
            assertThat(after(kind, mode == 0 ? 1 : -1, rate)).isCloseTo(expected, within(SLACK));
        }
    }

    @Test
    void theStabilityLimitKnowsTheLighterTranslation() {
        ParticleSystem system = pair(0, 0);
        // The measured frequency is raised by 3 %.
        assertThat(StabilityLimit.of(system).omegaMax())
                .isBetween(Math.sqrt(LIGHTNESS * HELD / KG), 1.04 * Math.sqrt(LIGHTNESS * HELD / KG));
    }

    @Test
    void kineticEnergyIsThatOfTheLighterGroup() {
        ParticleSystem system = pair(BETWEEN, 0);
        double[] v = system.velocities();
        v[1] = 3;
        v[4] = 3;
        assertThat(system.kineticEnergy()).isCloseTo(0.5 * 2 * KG / LIGHTNESS * 9, within(1e-12));
        v[4] = -3;
        assertThat(system.kineticEnergy()).isCloseTo(0.5 * 2 * KG * 9, within(1e-12));
    }

    /** Each force over the node's mass, and in the group (s - 1) / M of their sum besides. */
    private static double[] accelerations(double[] force) {
        double[] a = new double[force.length];
        for (int i = 0; i < a.length; i++) {
            boolean inGroup = i / 3 == GROUP[0] || i / 3 == GROUP[1];
            double sum = force[3 * GROUP[0] + i % 3] + force[3 * GROUP[1] + i % 3];
            a[i] = force[i] / UNEQUAL_KG[i / 3] + (inGroup ? (LIGHTNESS - 1) / 0.8 * sum : 0);
        }
        return a;
    }

    private static double[] forces() {
        return new double[] {3, -1, 4, 1, 5, -9, 2, -6, 5, 3, 5, 8};
    }

    @Test
    void aGroupAmongOthersHasTheInertiaOfItsFormula() {
        SelectiveMass group = new SelectiveMass(GROUP, LIGHTNESS, UNEQUAL_KG);
        double[] a = accelerations(forces());
        double[] scaled = forces();
        group.scaleForces(scaled);
        double[] inertia = new double[12];
        double[] rooted = new double[12];
        for (int i = 0; i < 12; i++) {
            assertThat(scaled[i] / UNEQUAL_KG[i / 3]).isCloseTo(a[i], within(1e-12));
            inertia[i] = UNEQUAL_KG[i / 3] * a[i];
            rooted[i] = forces()[i] / Math.sqrt(UNEQUAL_KG[i / 3]);
        }
        group.addInertia(1, a, inertia);
        assertThat(inertia).containsExactly(forces(), within(1e-12));
        group.stretch(rooted);
        group.stretch(rooted);
        for (int i = 0; i < 12; i++) {
            assertThat(rooted[i] / Math.sqrt(UNEQUAL_KG[i / 3])).isCloseTo(a[i], within(1e-12));
        }
    }

    @ParameterizedTest
    @EnumSource
    void forcesOnAGroupAmongOthersAccelerateItByItsFormula(IntegratorKind kind) {
        ParticleSystem system =
                new ParticleSystem(NodeLayout.natural(4), new double[12], UNEQUAL_KG.clone(), Workers.of(1));
        system.add(new ConstantLoad(system.layout(), forces()));
        system.setSelectiveMass(GROUP, LIGHTNESS);
        Integrator integrator = kind.create(system);
        for (int i = 0; i < 10; i++) {
            integrator.step(i * STEP_S, STEP_S);
        }
        double[] expected = accelerations(forces());
        double energy = 0;
        for (int i = 0; i < 12; i++) {
            double v = system.velocities()[i];
            assertThat(v / (10 * STEP_S)).isCloseTo(expected[i], within(1e-6));
            energy += 0.5 * v * forces()[i] * 10 * STEP_S;
        }
        assertThat(system.kineticEnergy()).as("impulse times half the velocity").isCloseTo(energy, within(1e-9));
    }

    /** A node that is listed twice would weigh twice in the mean; of no nodes there is no mean. */
    @Test
    void groupsWithoutANodeOrWithOneListedTwiceAreRefused() {
        ParticleSystem system = pair(BETWEEN, 0);
        for (int[] group : new int[][] {{}, {0, 1, 1}}) {
            assertThatThrownBy(() -> system.setSelectiveMass(group, LIGHTNESS))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("found " + group.length + " nodes")
                    .hasMessageContaining("expected at least one and each once");
        }
    }
}
