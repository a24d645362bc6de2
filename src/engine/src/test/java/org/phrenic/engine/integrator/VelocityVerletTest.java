package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;

class VelocityVerletTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.VERLET;
    }

    @Override
    boolean keepsAngularMomentum() {
        return true;
    }

    /** 2,000 undamped periods at ω h = 0.2: the energy swings within a band that does not move. */
    @Test
    void energyStaysInItsBand() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1, 0);
        system.positions()[0] = 1;
        Integrator integrator = kind().create(system);
        int period = 31;
        double[] high = new double[2];
        double[] low = {1, 1};
        for (int i = 0; i < 2000 * period; i++) {
            integrator.step(i * 0.2, 0.2);
            double energy = system.kineticEnergy() + system.potentialEnergy();
            int part = i < 1000 * period ? 0 : 1;
            high[part] = Math.max(high[part], energy);
            low[part] = Math.min(low[part], energy);
        }
        // 1/2 m (v² + ω² x²) of 0.05 µJ at the start; the band's width is of the scheme's order in ω h.
        assertThat(high[0]).isLessThan(0.05 * (1 + 0.011));
        assertThat(low[0]).isGreaterThan(0.05 * (1 - 0.011));
        assertThat(high[1]).isCloseTo(high[0], within(1e-6));
        assertThat(low[1]).isCloseTo(low[0], within(1e-6));
    }
}
