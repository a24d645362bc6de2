package org.phrenic.engine.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

class RigidLinksTest {
    private static final double ROUNDING = 1e-12;

    private static ParticleSystem system(double[] x, double... mass) {
        return new ParticleSystem(NodeLayout.natural(mass.length), x, mass, Workers.of(1));
    }

    private static RigidLinks sweeping(
            ParticleSystem system, int[] a, int[] b, double[] at, double tolerance, int max) {
        return RigidLinks.gaussSeidel(system.layout(), a, b, at, tolerance, max);
    }

    /**
     * Eq. 5 by hand: A'(0, 0, 0), B'(6, 8, 0) 10 mm apart, length 6, masses 1 and 3: the 4 mm too many are shared 3 :
     * 1, so A goes 3 mm and B 1 mm along (0.6, 0.8, 0). Velocities get the same over h = 0.5.
     */
    @Test
    void correctionIsSharedByInverseMassAlongTheLine() {
        double[] rest = {0, 0, 0, 0, 6, 0};
        for (boolean published : new boolean[] {true, false}) {
            ParticleSystem system = system(new double[] {0, 0, 0, 6, 8, 0}, 1, 3);
            // A motion of both ends together does not matter.
            system.velocities()[2] = 2;
            system.velocities()[5] = 2;
            int[] a = {0};
            int[] b = {1};
            RigidLinks links = published
                    ? RigidLinks.singlePass(system.layout(), a, b, rest)
                    : sweeping(system, a, b, rest, 1e-9, 5);
            assertThat(links.error(system)).isCloseTo(4.0 / 6, within(ROUNDING));
            links.project(system, 0.5);
            assertThat(system.positions()).containsExactly(new double[] {1.8, 2.4, 0, 5.4, 7.2, 0}, within(ROUNDING));
            assertThat(system.velocities())
                    .containsExactly(new double[] {3.6, 4.8, 2, -1.2, -1.6, 2}, within(ROUNDING));
            assertThat(links.error(system)).isLessThan(ROUNDING);
        }
    }

    /**
     * A free pair that turns by 0.2 rad a step: sweeping shifts along the line before the step and keeps angular
     * momentum; along the line after it, as published, a turn of θ a step shrinks by θ³, so that 0.2 rad falls by 1/√(1
     * + 2 n θ²) = 1/3 in n = 100 steps.
     */
    @Test
    void turningPairKeepsItsAngularMomentum() {
        double h = 0.02;
        for (boolean published : new boolean[] {true, false}) {
            ParticleSystem system = system(new double[] {-3, 0, 0, 1, 0, 0}, 1, 3);
            double[] rest = system.positions().clone();
            int[] a = {0};
            int[] b = {1};
            RigidLinks links = published
                    ? RigidLinks.singlePass(system.layout(), a, b, rest)
                    : sweeping(system, a, b, rest, 1e-9, 5);
            double[] x = system.positions();
            double[] v = system.velocities();
            v[1] = -30;
            v[4] = 10;
            for (int step = 0; step < 100; step++) {
                for (int i = 0; i < 6; i++) {
                    x[i] += h * v[i];
                }
                links.project(system, h);
                assertThat(links.error(system)).isLessThan(ROUNDING);
            }
            double spin = x[0] * v[1] - x[1] * v[0] + 3 * (x[3] * v[4] - x[4] * v[3]);
            assertThat(spin / 120).isCloseTo(published ? 1.0 / 3 : 1, within(published ? 0.01 : 1e-10));
        }
    }

    /**
     * A link that swung by a right angle in one step has no usable line before it: it is put back along the line it
     * has.
     */
    @Test
    void tooLargeATurnFallsBackToTheLineAtHand() {
        ParticleSystem system = system(new double[] {0, 0, 0, 0, 7, 0}, 1, 1);
        system.fix(0);
        system.velocities()[3] = -500;
        system.velocities()[4] = 700;
        RigidLinks links = sweeping(system, new int[] {0}, new int[] {1}, new double[] {0, 0, 0, 5, 0, 0}, 1e-9, 5);
        links.project(system, 0.01);
        assertThat(system.positions()).containsExactly(new double[] {0, 0, 0, 0, 5, 0}, within(ROUNDING));
    }

    /** Equal masses: AA₁/AA' = BB₁/BB' of the paper; a held end leaves all of it to the other. */
    @Test
    void heldEndMovesOnlyTheOther() {
        ParticleSystem system = system(new double[] {0, 0, 0, 6, 8, 0}, 1, 1);
        system.fix(0);
        RigidLinks links = sweeping(system, new int[] {0}, new int[] {1}, new double[] {0, 0, 0, 0, 5, 0}, 1e-9, 5);
        links.project(system, 0.1);
        assertThat(system.positions()).containsExactly(new double[] {0, 0, 0, 3, 4, 0}, within(ROUNDING));
        assertThat(system.velocities()).containsExactly(new double[] {0, 0, 0, -30, -40, 0}, within(1e-10));
        system.fix(0, 1);
        double[] before = system.positions().clone();
        system.positions()[0] = before[0] = 1;
        links.project(system, 0.1);
        assertThat(system.positions()).isEqualTo(before);
    }

    @Test
    void oneLinkANodeIsExactInOnePass() {
        int pairs = 3000;
        double[] rest = new double[6 * pairs];
        Random random = new Random(1);
        Arrays.setAll(rest, i -> 100 * random.nextDouble());
        int[] a = IntStream.range(0, pairs).toArray();
        int[] b = IntStream.range(pairs, 2 * pairs).toArray();
        double[] x = new double[rest.length];
        Arrays.setAll(x, i -> rest[i] + random.nextDouble());
        ParticleSystem system =
                new ParticleSystem(NodeLayout.morton(x), x, SampleSystems.masses(2 * pairs, 0.1), Workers.of(2));
        RigidLinks links = sweeping(system, a, b, rest, 1e-9, 50);
        assertThat(links.count()).isEqualTo(pairs);
        links.project(system, 0.01);
        assertThat(links.lastSweepCount()).isEqualTo(1);
        assertThat(links.error(system)).isLessThan(1e-11);
        system.workers().close();
    }

    /** A tetrahedron and a chain of ten links, out of shape by some percent. */
    @Test
    void sweepsUntilTheToleranceIsMet() {
        double[] rest = new double[3 * 14];
        System.arraycopy(new double[] {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10}, 0, rest, 0, 12);
        for (int i = 4; i < 14; i++) {
            rest[3 * i] = 10 * (i - 2);
            rest[3 * i + 1] = i % 2;
        }
        int[] a = {0, 0, 0, 1, 1, 2, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        int[] b = {1, 2, 3, 2, 3, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
        double[] x = rest.clone();
        Random random = new Random(2);
        for (int i = 0; i < x.length; i++) {
            x[i] += 0.6 * random.nextDouble();
        }
        double[] mass = random.doubles(14, 0.05, 0.3).toArray();
        ParticleSystem system = new ParticleSystem(NodeLayout.morton(x), x, mass, Workers.of(1));
        RigidLinks links = sweeping(system, a, b, rest, 1e-6, 1000);
        double[] before = momentum(system);
        links.project(system, 0.01);
        assertThat(links.error(system)).isLessThan(2e-6);
        assertThat(links.lastSweepCount()).isBetween(3, 500);
        assertThat(momentum(system)).containsExactly(before, within(1e-10));
        // Nothing is left to do.
        links.project(system, 0.01);
        assertThat(links.lastSweepCount()).isLessThanOrEqualTo(2);
    }

    /** Momentum and m x, which the shifts keep alike. */
    private static double[] momentum(ParticleSystem system) {
        double[] sum = new double[6];
        for (int i = 0; i < 3 * system.nodeCount(); i++) {
            sum[i % 3] += system.masses()[i / 3] * system.velocities()[i];
            sum[3 + i % 3] += system.masses()[i / 3] * system.positions()[i];
        }
        return sum;
    }

    /** The published pass, link by link in the order given: the second sees what the first did. */
    @Test
    void publishedPassGoesThroughLinksInOrder() {
        double[] rest = {0, 0, 0, 1, 0, 0, 2, 0, 0};
        for (boolean backwards : new boolean[] {false, true}) {
            ParticleSystem system = system(new double[] {0, 0, 0, 2, 0, 0, 4, 0, 0}, 1, 1, 1);
            int[] a = backwards ? new int[] {1, 0} : new int[] {0, 1};
            int[] b = backwards ? new int[] {2, 1} : new int[] {1, 2};
            RigidLinks links = RigidLinks.singlePass(system.layout(), a, b, rest);
            links.project(system, 1);
            assertThat(links.lastSweepCount()).isEqualTo(1);
            // Forwards: 0, 2 -> 0.5, 1.5; then 1.5, 4 -> 2.25, 3.25. Backwards it is the mirror image.
            double[] x = system.positions();
            assertThat(new double[] {x[0], x[3], x[6]})
                    .containsExactly(
                            backwards ? new double[] {0.75, 1.75, 3.5} : new double[] {0.5, 2.25, 3.25},
                            within(ROUNDING));
        }
    }

    /** Lengths 1, 1 and 5 make no triangle: nothing meets them, and nothing may break over it. */
    @Test
    void conflictingLinksStayFinite() {
        double[] rest = {0, 0, 0, 1, 0, 0, 6, 0, 0};
        double[] x = {0, 0, 0, 1, 0.2, 0, 0.5, 1, 0};
        ParticleSystem system = system(x, 1, 1, 1);
        RigidLinks tooLong = sweeping(system, new int[] {0, 1, 0}, new int[] {1, 2, 2}, rest, 1e-9, 50);
        RigidLinks tooShort =
                sweeping(system, new int[] {0}, new int[] {2}, new double[] {0, 0, 0, 0, 0, 0, 1, 0, 0}, 1e-9, 50);
        system.add(tooLong);
        system.add(tooShort);
        for (int i = 0; i < 200; i++) {
            system.project(i * 0.01, 0.01);
        }
        assertThat(tooLong.lastSweepCount()).isEqualTo(50);
        assertThat(Arrays.stream(system.positions()).allMatch(value -> Math.abs(value) < 10))
                .isTrue();
    }

    /** Ends that fell on one spot have no line to be put on: they are left to the forces, and the error says so. */
    @Test
    void linkWithBothEndsOnOneSpotStaysFinite() {
        ParticleSystem system = system(new double[] {1, 2, 3, 1, 2, 3}, 1, 1);
        RigidLinks links = sweeping(system, new int[] {0}, new int[] {1}, new double[] {0, 0, 0, 1, 0, 0}, 1e-9, 5);
        links.project(system, 0.01);
        assertThat(system.positions()).containsExactly(1, 2, 3, 1, 2, 3);
        assertThat(links.error(system)).isEqualTo(1);
    }

    @Test
    void lostPositionShowsInTheError() {
        ParticleSystem system = system(new double[] {1, 2, 3, 1, 2, 4}, 1, 1);
        RigidLinks links = sweeping(
                system, new int[] {0}, new int[] {1}, system.positions().clone(), 1e-9, 5);
        system.positions()[0] = Double.NaN;
        assertThat(links.error(system)).isNaN();
    }

    @Test
    void refusesALinkWithoutLength() {
        ParticleSystem system = system(new double[6], 1, 1);
        assertThatThrownBy(() -> sweeping(system, new int[] {0}, new int[] {1}, new double[6], 1e-9, 5))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("rigid link 0 between nodes 0 and 1: found length 0.0 mm");
    }

    @Test
    void refusesALinkFromANodeToItself() {
        assertThatThrownBy(() -> RigidLinks.gaussSeidelToLengths(
                        NodeLayout.natural(2), new int[] {0, 1}, new int[] {1, 1}, new double[] {5, 5}, 1e-9, 20))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("rigid link 1: found node 1 at both ends, expected two nodes");
    }

    @Test
    void noLinksAreNoWork() {
        ParticleSystem system = system(new double[6], 1, 1);
        RigidLinks links = sweeping(system, new int[0], new int[0], new double[6], 1e-9, 5);
        links.project(system, 0.01);
        assertThat(links.count()).isZero();
        assertThat(links.error(system)).isZero();
    }
}
