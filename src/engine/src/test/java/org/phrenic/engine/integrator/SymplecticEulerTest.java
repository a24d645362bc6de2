package org.phrenic.engine.integrator;

import org.junit.jupiter.api.Test;

class SymplecticEulerTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.SYMPLECTIC_EULER;
    }

    @Override
    boolean keepsAngularMomentum() {
        return true;
    }

    @Test
    void energyStaysInItsBand() {
        assertEnergyStaysInItsBand(0.12, 0.1);
    }
}
