package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Slow motion is free of viscosity, fast motion is not. */
class SlowMotionReleaseTest {
    private static final double KG = 0.2;
    private static final double RATE = 8;
    private static final double TIME_S = 0.1;
    private static final double STEP_S = 1e-4;

    /** Velocity of a node that a constant force pushes for a second from rest. */
    private static double pushed(IntegratorKind kind, double acceleration) {
        ParticleSystem system = SampleSystems.oneNode(KG);
        system.setViscosityPerMass(RATE);
        system.add(new ConstantLoad(system.layout(), new double[] {KG * acceleration, 0, 0}));
        system.add(new SlowMotionRelease(system, TIME_S));
        Integrator integrator = kind.create(system);
        int steps = (int) Math.round(1 / STEP_S);
        for (int i = 0; i < steps; i++) {
            integrator.step(i * STEP_S, STEP_S);
        }
        return system.velocities()[0];
    }

    @ParameterizedTest
    @EnumSource
    void steadyAccelerationMeetsAnAddedMassAndNoDrag(IntegratorKind kind) {
        // v' = a - r (v - u), u' = (v - u) / τ: v - u tends to a τ / (1 + r τ), so v' to a / (1 + r τ).
        double a = 10;
        double grown = 1 + RATE * TIME_S;
        double lag = a * TIME_S / grown;
        double decayed = lag / grown * RATE * TIME_S * (1 - Math.exp(-grown / TIME_S));
        assertThat(pushed(kind, a)).isCloseTo(a / grown + decayed, within(0.005 * a));
    }

    /** Amplitude that is left of a swing of one node after half a second, as a decay rate. */
    private static double decayRate(double omega) {
        ParticleSystem system = SampleSystems.oneNode(KG);
        system.add(new Attachments(
                system.layout(),
                new int[] {0},
                new double[] {KG * omega * omega},
                0,
                PrescribedMotion.stationary(new double[3])));
        system.setViscosityPerMass(RATE);
        system.add(new SlowMotionRelease(system, TIME_S));
        system.positions()[0] = 1;
        Integrator integrator = IntegratorKind.VERLET.create(system);
        double first = 0;
        double second = 0;
        for (int i = 0; i < 20_000; i++) {
            integrator.step(i * STEP_S, STEP_S);
            double size = Math.hypot(system.positions()[0], system.velocities()[0] / omega);
            if (i < 10_000) {
                first = size;
            } else {
                second = size;
            }
        }
        return -Math.log(second / first);
    }

    @ParameterizedTest
    @ValueSource(doubles = {60, 200})
    void fastSwingsDieDownAtHalfTheRate(double omega) {
        double share = Math.pow(omega * TIME_S, 2) / (1 + Math.pow(omega * TIME_S, 2));
        assertThat(decayRate(omega)).isCloseTo(0.5 * RATE * share, within(0.05 * RATE));
    }

    @ParameterizedTest
    @EnumSource
    void steadyMotionGoesOn(IntegratorKind kind) {
        ParticleSystem system = SampleSystems.oneNode(KG);
        system.setViscosityPerMass(RATE);
        system.add(new SlowMotionRelease(system, TIME_S));
        system.velocities()[0] = 5;
        Integrator integrator = kind.create(system);
        for (int i = 0; i < 10_000; i++) {
            integrator.step(i * STEP_S, STEP_S);
        }
        assertThat(system.velocities()[0]).isCloseTo(5, within(1e-6));
    }

    /** A group of unequal nodes, a tenth as heavy in translation, and a node beside it. */
    private static ParticleSystem group() {
        ParticleSystem system =
                new ParticleSystem(NodeLayout.natural(3), new double[9], new double[] {0.2, 0.5, 0.6}, Workers.of(1));
        system.setSelectiveMass(new int[] {0, 2}, 10);
        system.setViscosityPerMass(RATE);
        system.add(new SlowMotionRelease(system, TIME_S));
        return system;
    }

    /** From rest at once at constant velocities: after τ the means are 1 - 1/e of them. */
    @Test
    void onALighterGroupTheForceIsSmallerByTheReliefOfItsMeanVelocity() {
        ParticleSystem system = group();
        double[] v = system.velocities();
        double[] force = new double[9];
        system.forces(0, system.positions(), v, force);
        v[0] = 3;
        v[3] = 7;
        v[6] = 5;
        for (int i = 1; i <= 100; i++) {
            system.forces(i * TIME_S / 100, system.positions(), v, force);
        }
        double mean = (0.2 * 3 + 0.6 * 5) / 0.8;
        double share = RATE * (1 - Math.exp(-1));
        assertThat(force[0]).isCloseTo(share * 0.2 * (3 - 0.9 * mean), within(1e-9));
        assertThat(force[3]).isCloseTo(share * 0.5 * 7, within(1e-9));
        assertThat(force[6]).isCloseTo(share * 0.6 * (5 - 0.9 * mean), within(1e-9));
    }

    @ParameterizedTest
    @EnumSource
    void steadyMotionOfALighterGroupGoesOn(IntegratorKind kind) {
        ParticleSystem system = group();
        system.velocities()[0] = 5;
        system.velocities()[6] = 5;
        Integrator integrator = kind.create(system);
        for (int i = 0; i < 10_000; i++) {
            integrator.step(i * STEP_S, STEP_S);
        }
        assertThat(system.velocities()[0]).isCloseTo(5, within(1e-6));
        assertThat(system.velocities()[6]).isCloseTo(5, within(1e-6));
    }

    @Test
    void atRestThereIsNoForce() {
        ParticleSystem system =
                new ParticleSystem(NodeLayout.natural(1), new double[3], new double[] {KG}, Workers.of(1));
        system.setViscosityPerMass(RATE);
        system.add(new SlowMotionRelease(system, TIME_S));
        system.velocities()[0] = 100;
        double[] force = new double[3];
        system.forces(0, system.positions(), new double[3], force);
        assertThat(force).containsExactly(0, 0, 0);
    }

    /** After a divergence the state is restored at an earlier time: what the velocity has been is forgotten. */
    @Test
    void aRestoredStateForgetsTheMeanOfADivergedOne() {
        ParticleSystem diverged = SampleSystems.oneNode(KG);
        diverged.setViscosityPerMass(RATE);
        SlowMotionRelease release = new SlowMotionRelease(diverged, TIME_S);
        diverged.add(release);
        double[] force = new double[3];
        for (double speed : new double[] {0.1, 1e300, Double.NaN}) {
            diverged.velocities()[0] = speed;
            diverged.forces(2, diverged.positions(), diverged.velocities(), force);
        }
        release.invalidate();
        diverged.velocities()[0] = 0.3;
        diverged.forces(1, diverged.positions(), diverged.velocities(), force);
        // With u = v to the last bit the force is γ v.
        assertThat(force[0]).isEqualTo(diverged.viscosities()[0] * 0.3);
    }

    /** Made before the group it would drive the group instead of releasing it. */
    @Test
    void aGroupThatIsMadeLighterLaterIsRefused() {
        ParticleSystem system = SampleSystems.oneNode(KG);
        system.setViscosityPerMass(RATE);
        system.add(new SlowMotionRelease(system, TIME_S));
        system.setSelectiveMass(new int[] {0}, 10);
        Integrator integrator = IntegratorKind.VERLET.create(system);
        assertThatThrownBy(() -> integrator.step(0, STEP_S))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("expected setSelectiveMass before it");
    }
}
