package org.phrenic.engine.integrator;

import org.junit.jupiter.api.Test;

class VelocityVerletTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.VERLET;
    }

    @Override
    boolean keepsAngularMomentum() {
        return true;
    }

    @Test
    void energyStaysInItsBand() {
        assertEnergyStaysInItsBand(0.011, 0.011);
    }
}
