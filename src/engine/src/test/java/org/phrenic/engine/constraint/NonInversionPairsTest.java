package org.phrenic.engine.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** The order of two faces: node 3 below the triangle 0, 1, 2, whose normal is +z. */
class NonInversionPairsTest {
    private static final double H = 0.001;

    private static ParticleSystem pair(double innerZ) {
        double[] x = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, innerZ};
        NodeLayout layout = NodeLayout.morton(x);
        ParticleSystem system = new ParticleSystem(layout, x, new double[] {1, 1, 1, 3}, Workers.of(1));
        system.add(new NonInversionPairs(
                layout, new int[] {0}, new int[] {3}, new int[] {0, 1, 2}, new double[] {1}, 0.01));
        return system;
    }

    private static double height(ParticleSystem system, int node) {
        double[] x = new double[3];
        system.position(node, x);
        return x[2];
    }

    @Test
    void aPairThatIsTooCloseIsPutApartByInverseMass() {
        ParticleSystem system = pair(-0.96);
        system.project(0, H);
        assertThat(height(system, 0)).isCloseTo(0.03, within(1e-12));
        assertThat(height(system, 3)).isCloseTo(-0.97, within(1e-12));
    }

    /** Faces 3 mm past each other: put back at once, they would be thrown at 3 m/s by what opposes it. */
    @Test
    void anInvertedPairReturnsNoFasterThanTheWallPutsANodeBack() {
        ParticleSystem system = pair(2);
        system.project(0, H);
        double step = SlidingContact.MAX_RETURN_SPEED * H;
        assertThat(height(system, 0)).isCloseTo(0.75 * step, within(1e-12));
        assertThat(height(system, 3)).isCloseTo(2 - 0.25 * step, within(1e-12));
    }
}
