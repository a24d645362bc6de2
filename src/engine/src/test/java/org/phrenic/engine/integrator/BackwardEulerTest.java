package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleMotions;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.force.Attachments;

class BackwardEulerTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.BACKWARD_EULER;
    }

    @Override
    boolean keepsAngularMomentum() {
        return false;
    }

    /** Conjugate gradients stop at a residual of 1e-8. */
    @Override
    double momentumTolerance() {
        return 1e-7;
    }

    /**
     * Undamped, at steps far beyond what explicit schemes stand (ω h = 10): the energy falls in each step by 1/(1 +
     * y²).
     */
    @Test
    void energyNeverGrows() {
        for (double y : new double[] {0.1, 1, 10}) {
            ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * y * y, 0);
            system.positions()[0] = 1;
            system.velocities()[1] = y;
            Integrator integrator = kind().create(system);
            double before = system.kineticEnergy() + system.potentialEnergy();
            for (int i = 0; i < 20; i++) {
                integrator.step(i, 1);
                double after = system.kineticEnergy() + system.potentialEnergy();
                assertThat(after / before).isCloseTo(1 / (1 + y * y), within(MANY_ROUNDINGS));
                before = after;
            }
        }
    }

    /** What is held stiffly is where its anchor is at the end of the step, not where it was. */
    @Test
    void takesAnchorsAtTheEndOfTheStep() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.add(new Attachments(
                system.layout(), new int[] {0}, new double[] {1e9}, 0, SampleMotions.swinging(new double[3], 0, 2, 3)));
        kind().create(system).step(0, 0.3);
        assertThat(system.positions()[0]).isCloseTo(2 * Math.sin(0.9), within(1e-6));
    }

    /**
     * A hundred times the largest step of velocity Verlet on a net far from rest: it comes to rest instead of flying
     * apart.
     */
    @Test
    void staysStableAtAnyStep() {
        ParticleSystem system = SampleSystems.net(0);
        double h = 100 * StabilityLimit.of(system).largestStep(IntegratorKind.VERLET);
        system.setViscosityPerMass(1);
        Integrator integrator = kind().create(system);
        double before = system.kineticEnergy() + system.potentialEnergy();
        for (int i = 0; i < 50; i++) {
            integrator.step(i * h, h);
        }
        assertThat(system.kineticEnergy() + system.potentialEnergy()).isLessThan(0.01 * before);
        assertThat(((BackwardEuler) integrator).lastIterationCount()).isLessThan(100);
    }
}
