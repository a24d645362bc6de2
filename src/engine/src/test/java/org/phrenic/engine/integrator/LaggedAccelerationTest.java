package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;

class LaggedAccelerationTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.LAGGED;
    }

    @Override
    boolean keepsAngularMomentum() {
        return false;
    }

    /** Without damping the amplitude grows like exp(h ω² t / 2), the energy like its square. */
    @Test
    void energyGrowsAsTheLagSays() {
        double h = 0.001;
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * 100, 0);
        system.positions()[0] = 1;
        double before = system.potentialEnergy();
        run(kind().create(system), 20, 20_000);
        double after = system.kineticEnergy() + system.potentialEnergy();
        assertThat(Math.log(after / before)).isCloseTo(h * 100 * 20, within(0.02));
    }

    @Test
    void viscosityAboveHOmegaSquaredHoldsIt() {
        double h = 0.001;
        for (double share : new double[] {0.95, 1.05}) {
            ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * 100, 0.1 * h * 100 * share);
            system.positions()[0] = 1;
            run(kind().create(system), 300, 300_000);
            double ratio = (system.kineticEnergy() + system.potentialEnergy()) / 5;
            assertThat(ratio < 1).isEqualTo(share > 1);
        }
    }
}
