package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** A bent lattice stores the energy of a plate; what moves without bending costs nothing. */
class HingeBendingTest {
    private static final double STIFFNESS = 250;
    private static final double EDGE = 5;
    private static final double HEIGHT = EDGE * Math.sqrt(3) / 2;
    private static final double EXACT = 1e-9;

    /** Node 0 in the middle of the nodes that the hinges about its three edges reach. */
    private static double[] lattice() {
        double[][] plane = {{0, 0}, {1, 0}, {0.5, 1}, {-0.5, 1}, {-1, 0}, {0.5, -1}};
        double[] p = new double[3 * plane.length];
        for (int i = 0; i < plane.length; i++) {
            p[3 * i] = EDGE * plane[i][0];
            p[3 * i + 1] = HEIGHT * plane[i][1];
        }
        return p;
    }

    /** The edges from node 0 in the three directions of the lattice, which hold the energy of one node's area. */
    private static final int[] HINGES = {0, 1, 2, 5, 0, 2, 1, 3, 0, 3, 2, 4};

    private static HingeBending bending(double[] rest) {
        double[] stiffness = new double[HINGES.length / 4];
        Arrays.fill(stiffness, STIFFNESS);
        return new HingeBending(layout(), Hinges.of(rest, HINGES, stiffness), rest);
    }

    private static NodeLayout layout() {
        return NodeLayout.natural(lattice().length / 3);
    }

    private static double[] forces(HingeBending field, double[] x) {
        double[] force = new double[x.length];
        field.addForces(x, new double[x.length], force, 0);
        return force;
    }

    /** Density of a plate's energy D κ² / 2 on the area of a node, √3/2 l². */
    @Test
    void aCylinderStoresTheEnergyOfAPlateInEveryDirection() {
        double curvature = 0.01;
        for (double degrees : new double[] {0, 17, 30, 90, 135}) {
            double[] x = lattice();
            for (int i = 0; i < x.length; i += 3) {
                double along = x[i] * Math.cos(Math.toRadians(degrees)) + x[i + 1] * Math.sin(Math.toRadians(degrees));
                x[i + 2] = 0.5 * curvature * along * along;
            }
            double expected = 0.5 * STIFFNESS * curvature * curvature * EDGE * HEIGHT;
            assertThat(bending(lattice()).potentialEnergy(x)).isCloseTo(expected, within(EXACT * expected));
        }
    }

    /** Forces, their derivative, row sums and energy: those of the hinges, times the scale. */
    @Test
    void aScaleMultipliesEverythingThatTheStiffnessGives() {
        double[] rest = lattice();
        rest[2] = 0.7;
        double[] x = lattice();
        Random random = new Random(7);
        Arrays.setAll(x, i -> x[i] + random.nextDouble());
        double[] of = {STIFFNESS, STIFFNESS, STIFFNESS};
        HingeBending scaled = new HingeBending(layout(), Hinges.of(rest, HINGES, of), rest);
        Arrays.setAll(of, i -> 3 * of[i]);
        HingeBending stiffer = new HingeBending(layout(), Hinges.of(rest, HINGES, of), rest);
        scaled.setScale(3);
        assertThat(forces(scaled, x)).containsExactly(forces(stiffer, x), within(EXACT));
        assertThat(stiffness(scaled, x)).containsExactly(stiffness(stiffer, x), within(EXACT));
        assertThat(rowSums(scaled, x)).containsExactly(rowSums(stiffer, x), within(EXACT));
        assertThat(scaled.potentialEnergy(x)).isCloseTo(stiffer.potentialEnergy(x), within(EXACT));
    }

    /** Where forces are kept they and the energy stay; from there the stiffness is that of the scale. */
    @Test
    void aScaleKeepsForceAndEnergyWhereTheyAreKept() {
        double[] rest = lattice();
        rest[2] = 0.7;
        Random random = new Random(8);
        double[] kept = rest.clone();
        Arrays.setAll(kept, i -> kept[i] + random.nextDouble());
        double[] away = kept.clone();
        Arrays.setAll(away, i -> away[i] + random.nextDouble());
        double[] step = new double[away.length];
        Arrays.setAll(step, i -> kept[i] - away[i]);
        double[] expected = forces(bending(rest), kept);
        double[] pull = stiffness(bending(rest), step);
        double energy = bending(rest).potentialEnergy(kept);
        for (boolean scaledBefore : new boolean[] {false, true}) {
            HingeBending field = bending(rest);
            if (scaledBefore) {
                field.setScale(3);
                field.keepForcesAt(kept);
            } else {
                field.keepForcesAt(kept);
                field.setScale(3);
            }
            assertThat(forces(field, kept)).containsExactly(expected, within(EXACT));
            assertThat(field.potentialEnergy(kept)).isCloseTo(energy, within(EXACT));
            double[] there = forces(field, away);
            for (int i = 0; i < there.length; i++) {
                assertThat(there[i]).isCloseTo(expected[i] + 3 * pull[i], within(EXACT));
            }
            field.setScale(1);
            assertThat(forces(field, away)).isEqualTo(forces(bending(rest), away));
            assertThat(field.potentialEnergy(away)).isEqualTo(bending(rest).potentialEnergy(away));
        }
    }

    private static double[] stiffness(HingeBending field, double[] u) {
        double[] out = new double[u.length];
        field.addStiffness(u, u, out, 0);
        return out;
    }

    private static double[] rowSums(HingeBending field, double[] x) {
        double[] sums = new double[x.length / 3];
        field.addRowSums(x, sums, new double[sums.length]);
        return sums;
    }

    @Test
    void translationAndStretchOfAPlaneCostNothing() {
        double[] x = lattice();
        for (int i = 0; i < x.length; i += 3) {
            x[i] = 3 + 0.6 * x[i] + 0.2 * x[i + 1];
            x[i + 1] = -7 + 1.1 * x[i + 1];
            x[i + 2] = 11;
        }
        for (double f : forces(bending(lattice()), x)) {
            assertThat(f).isCloseTo(0, within(EXACT));
        }
    }

    @Test
    void aCurvedShapeIsAtRestAndKeepsMomentumWhenItMoves() {
        double[] rest = lattice();
        Random random = new Random(5);
        Arrays.setAll(rest, i -> rest[i] + 0.8 * random.nextDouble());
        HingeBending field = bending(rest);
        for (double f : forces(field, rest)) {
            assertThat(f).isCloseTo(0, within(EXACT));
        }
        double[] x = rest.clone();
        Arrays.setAll(x, i -> x[i] + random.nextDouble());
        double[] f = forces(field, x);
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int i = axis; i < f.length; i += 3) {
                sum += f[i];
            }
            assertThat(Math.abs(f[axis])).isGreaterThan(1);
            assertThat(sum).isCloseTo(0, within(EXACT));
        }
    }

    /** One hinge of equal masses has one frequency, ω² = Σ w² / m. */
    @Test
    void theStiffnessOfAHingeSetsTheStep() {
        double mass = 1e-3;
        Hinges hinge = Hinges.of(lattice(), Arrays.copyOf(HINGES, 4), new double[] {STIFFNESS});
        ParticleSystem plate = new ParticleSystem(
                layout(), lattice(), SampleSystems.masses(lattice().length / 3, mass), Workers.of(1));
        plate.add(new HingeBending(layout(), hinge, lattice()));
        double squares = Arrays.stream(hinge.weights()).map(w -> w * w).sum();
        double omega = Math.sqrt(squares / mass);
        // The estimate is raised by 3 %.
        assertThat(StabilityLimit.of(plate).omegaMax()).isBetween(omega, 1.04 * omega);
    }

    /** Masses equal to their row sums have no frequency above 1/s, however crooked the triangles. */
    @Test
    void rowSumsBoundTheFrequency() {
        double[] crooked = lattice();
        Random random = new Random(6);
        Arrays.setAll(crooked, i -> crooked[i] + 1.5 * random.nextDouble());
        Hinges hinges = Hinges.of(crooked, HINGES, new double[] {STIFFNESS, 2 * STIFFNESS, STIFFNESS});
        double[] mass = new double[crooked.length / 3];
        for (int i = 0; i < hinges.corners().length; i++) {
            mass[hinges.corners()[i]] += hinges.rowSums()[i];
        }
        ParticleSystem plate = new ParticleSystem(layout(), crooked, mass, Workers.of(1));
        plate.add(new HingeBending(layout(), hinges, crooked));
        assertThat(StabilityLimit.of(plate).omegaMax()).isBetween(0.5, 1 + EXACT);
    }

    /** Node by node after the formula, on a plate whose hinges reach across blocks. */
    @Test
    void blocksDoNotShowInTheForces() {
        int columns = 60;
        int rows = 30;
        double[] rest = new double[3 * columns * rows];
        for (int i = 0; i < columns * rows; i++) {
            rest[3 * i] = EDGE * (i % columns + 0.5 * (i / columns));
            rest[3 * i + 1] = HEIGHT * (i / columns);
        }
        int[] nodes = IntStream.range(0, columns * rows)
                .filter(i -> i % columns > 0 && i % columns < columns - 1 && i / columns < rows - 1)
                .flatMap(i -> IntStream.of(i, i + columns, i + 1, i + columns - 1))
                .toArray();
        double[] stiffness = new double[nodes.length / 4];
        Arrays.fill(stiffness, STIFFNESS);
        Hinges hinges = Hinges.of(rest, nodes, stiffness);
        NodeLayout layout = NodeLayout.morton(rest);
        assertThat(layout.blockCount()).isGreaterThan(2);
        double[] moved = new Random(4).doubles(rest.length, -1, 1).toArray();
        double[] expected = new double[rest.length];
        for (int h = 0; h < 4 * hinges.count(); h += 4) {
            for (int axis = 0; axis < 3; axis++) {
                double bend = 0;
                for (int c = 0; c < 4; c++) {
                    bend += hinges.weights()[h + c] * moved[3 * nodes[h + c] + axis];
                }
                for (int c = 0; c < 4; c++) {
                    expected[3 * nodes[h + c] + axis] -= hinges.weights()[h + c] * bend;
                }
            }
        }
        Arrays.setAll(moved, i -> rest[i] + moved[i]);
        ParticleSystem plate =
                new ParticleSystem(layout, moved, SampleSystems.masses(columns * rows, 1), Workers.of(2));
        plate.add(new HingeBending(layout, hinges, rest));
        double[] force = new double[rest.length];
        plate.forces(0, plate.positions(), plate.velocities(), force);
        double[] found = new double[rest.length];
        layout.toCaller(force, found);
        for (int i = 0; i < found.length; i++) {
            assertThat(found[i]).isCloseTo(expected[i], within(EXACT));
        }
    }

    @Test
    void hingesWithoutAreaAreRefused() {
        double[] flat = new double[lattice().length];
        assertThatThrownBy(() -> bending(flat))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("hinge 0");
        assertThatThrownBy(() -> Hinges.of(lattice(), new int[] {0, 1, 2}, new double[] {1}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("four nodes each");
    }
}
