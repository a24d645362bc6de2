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
                layout, new int[] {0}, new int[] {3}, new int[][] {{0, 1, 2}}, new double[] {1}, 0.01));
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

    /** By inverse mass: 4 units of momentum are shared by a mass of 4. What is across the normal stays. */
    @Test
    void nodesThatApproachEachOtherGoOnTogetherAndThoseThatPartGoOnParting() {
        ParticleSystem closing = pair(-0.96);
        setVelocity(closing, 0, 0.5, -2);
        setVelocity(closing, 3, 0, 2);
        closing.project(0, H);
        assertThat(velocity(closing, 0)).containsExactly(0.5, 1);
        assertThat(velocity(closing, 3)).containsExactly(0, 1);
        ParticleSystem parting = pair(-0.96);
        setVelocity(parting, 0, 0.5, 2);
        setVelocity(parting, 3, 0, -2);
        parting.project(0, H);
        assertThat(velocity(parting, 0)).containsExactly(0.5, 2);
        assertThat(velocity(parting, 3)).containsExactly(0, -2);
    }

    private static void setVelocity(ParticleSystem system, int node, double vx, double vz) {
        int k = 3 * system.layout().internal(node);
        system.velocities()[k] = vx;
        system.velocities()[k + 2] = vz;
    }

    /** Along x and z. */
    private static double[] velocity(ParticleSystem system, int node) {
        int k = 3 * system.layout().internal(node);
        return new double[] {system.velocities()[k], system.velocities()[k + 2]};
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

    /**
     * Four triangles about the outer node, of which one has turned over: its far corner was carried across. Along that
     * triangle's own normal the pair is inverted; along the mean normal, which is +z, it is apart.
     */
    @Test
    void aTriangleThatTurnsOverInAFoldLeavesItsPairAlone() {
        double[] x = {0, 0, 0, 2, 0, 0, 0, 2, 0, -2, 0, 0, 0.4, 0.5, 0, 0, 0, -1.1};
        NodeLayout layout = NodeLayout.morton(x);
        double[] mass = {1, 1, 1, 1, 1, 3};
        int[] ring = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
        ParticleSystem system = new ParticleSystem(layout, x, mass, Workers.of(1));
        system.add(new NonInversionPairs(
                layout, new int[] {0}, new int[] {5}, new int[][] {ring}, new double[] {1}, 0.01));
        system.project(0, H);
        assertThat(height(system, 0)).isZero();
        assertThat(height(system, 5)).isEqualTo(-1.1);
        NonInversionPairs byOne = new NonInversionPairs(
                layout, new int[] {0}, new int[] {5}, new int[][] {{0, 4, 1}}, new double[] {1}, 0.01);
        byOne.prepare(system, 0);
        assertThat(byOne.error(system))
                .as("along the normal of the triangle that turned over")
                .isCloseTo(2.1, within(1e-12));
    }

    @Test
    void theNormalIsTheMeanOfTheRingWeightedByArea() {
        // Triangles of areas 2 and 1 in the planes z = 0 and x = 0: the mean normal is (1, 0, 2) / sqrt(5).
        double[] x = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, -1, 0, 0, -3};
        NodeLayout layout = NodeLayout.morton(x);
        ParticleSystem system = new ParticleSystem(layout, x, new double[] {1, 1, 1, 1, 1}, Workers.of(1));
        NonInversionPairs pairs = new NonInversionPairs(
                layout, new int[] {0}, new int[] {4}, new int[][] {{0, 1, 2, 0, 3, 2}}, new double[] {4}, 0.01);
        pairs.prepare(system, 0);
        assertThat(pairs.error(system)).isCloseTo(4 - 6 / Math.sqrt(5), within(1e-12));
    }
}
