package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;

class StormerTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.STORMER;
    }

    @Override
    boolean keepsAngularMomentum() {
        return false;
    }

    /** The first two steps are of lower order; after them the accelerations of three steps are known. */
    @Override
    int stepsBeforeItsMatrix() {
        return 2;
    }

    @Override
    void memory(Integrator integrator, double h, double[] state) {
        for (int i = 0; i < 3; i++) {
            state[2 + i] = ((Stormer) integrator).acceleration(i)[0] * h * h;
        }
    }

    /**
     * What is left of the amplitude after 200 undamped periods: the damping is h³ ω⁴ / 12 to leading order, exp(-h³ ω⁴
     * t / 24) of the amplitude.
     */
    @Test
    void dampsBySayingHowMuch() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1, 0);
        system.positions()[0] = 1;
        double duration = 200 * 2 * Math.PI;
        int n = (int) Math.round(duration / 0.05);
        double before = system.kineticEnergy() + system.potentialEnergy();
        run(kind().create(system), duration, n);
        double left = (system.kineticEnergy() + system.potentialEnergy()) / before;
        double h = duration / n;
        assertThat(left).isCloseTo(Math.exp(-h * h * h * duration / 12), within(1e-4));
    }

    /** At the same step the distance from the exact path is far below that of Verlet. */
    @Test
    void isNearerThanVerletForTheSameForces() {
        double[] error = new double[2];
        IntegratorKind[] kinds = {IntegratorKind.VERLET, kind()};
        for (int i = 0; i < 2; i++) {
            ParticleSystem system = SampleSystems.oscillator(0.1, 0.1, 0);
            system.positions()[0] = 1;
            run(kinds[i].create(system), 20, 200);
            error[i] = Math.abs(system.positions()[0] - Math.cos(20));
        }
        assertThat(error[1]).isLessThan(error[0] / 5);
    }
}
