package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;

class MidpointRungeKuttaTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.RK2;
    }

    @Override
    boolean keepsAngularMomentum() {
        return false;
    }

    /** Without damping both parts of the energy are multiplied by |R(i y)|² = 1 + y⁴/4 a step, y = ω h. */
    @Test
    void energyGrowsAsItsStabilityFunctionSays() {
        double y = 0.5;
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * y * y / 1e-4, 0);
        system.positions()[0] = 1;
        double before = system.kineticEnergy() + system.potentialEnergy();
        run(kind().create(system), 1, 100);
        double after = system.kineticEnergy() + system.potentialEnergy();
        assertThat(after / before).isCloseTo(Math.pow(1 + y * y * y * y / 4, 100), within(MANY_ROUNDINGS));
    }
}
