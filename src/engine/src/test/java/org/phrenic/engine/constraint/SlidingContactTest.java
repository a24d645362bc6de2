package org.phrenic.engine.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

class SlidingContactTest {
    private static final double ROUNDING = 1e-12;
    private static final double H = 0.001;

    private static SlidingContact contact(ParticleSystem system, ContactSurface wall, double refresh) {
        SlidingContact contact = new SlidingContact(system.layout(), new int[] {0}, wall, refresh);
        system.add(contact);
        return contact;
    }

    /**
     * A node pressed up against a ceiling that sinks at 20 mm/s: it sinks with it, and slides along it as if nothing
     * were there.
     */
    @ParameterizedTest
    @EnumSource(IntegratorKind.class)
    void nodeStaysOnItsSideOfAMovingWallAndSlidesFreely(IntegratorKind kind) {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, 50}));
        SlidingContact contact = contact(system, new SampleSystems.Ceiling(1, -20), 0.01);
        system.velocities()[0] = 7;
        system.velocities()[1] = -3;
        Integrator integrator = kind.create(system);
        for (int i = 0; i < 500; i++) {
            integrator.step(i * H, H);
            double wall = 1 - 20 * (i + 1) * H;
            assertThat(system.positions()[2]).isLessThanOrEqualTo(wall + ROUNDING * 10);
            assertThat(system.velocities()[0]).isEqualTo(7);
            assertThat(system.velocities()[1]).isEqualTo(-3);
        }
        assertThat(system.positions()[2]).isCloseTo(1 - 20 * 0.5, within(1e-9));
        assertThat(system.positions()[0]).isCloseTo(3.5, within(1e-9));
        assertThat(contact.contactCount()).isEqualTo(1);
        assertThat(contact.error(system)).isLessThan(ROUNDING * 10);
    }

    @Test
    void nodeLeavesFreely() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        ConstantLoad load = new ConstantLoad(system.layout(), new double[] {0, 0, 50});
        system.add(load);
        SlidingContact contact = contact(system, new SampleSystems.Ceiling(0.1, 0), 0.01);
        Integrator integrator = IntegratorKind.SYMPLECTIC_EULER.create(system);
        for (int i = 0; i < 100; i++) {
            integrator.step(i * H, H);
        }
        assertThat(contact.contactCount()).isEqualTo(1);
        load.setLoadFactor(-1);
        for (int i = 0; i < 100; i++) {
            integrator.step((100 + i) * H, H);
        }
        assertThat(contact.contactCount()).isZero();
        // 500 mm/s² down for 0.1 s from rest on the wall: nothing held it back. Symplectic Euler is g h t / 2 ahead.
        assertThat(system.velocities()[2]).isCloseTo(-50, within(1e-9));
        assertThat(system.positions()[2]).isCloseTo(0.1 - 2.5 - 500 * H * 0.1 / 2, within(1e-9));
    }

    /**
     * A wall with an edge: the plane of an adhering node lies 30 mm away at once. The node comes to it within steps.
     */
    @Test
    void anAdheringNodeFollowsAJumpOfItsPlaneAtALimitedSpeed() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.add(SlidingContact.adhering(system.layout(), new int[] {0}, new SampleSystems.Ceiling(30, 0), 0.01));
        Integrator integrator = IntegratorKind.VERLET.create(system);
        double largest = SlidingContact.MAX_ADHERING_SPEED * H;
        for (int i = 0; i < 15; i++) {
            integrator.step(i * H, H);
            assertThat(system.positions()[2]).isCloseTo((i + 1) * largest, within(1e-9));
            assertThat(system.velocities()[2]).isZero();
        }
        integrator.step(15 * H, H);
        assertThat(system.positions()[2]).isCloseTo(30, within(1e-9));
    }

    /** Beyond the wall but on its way back: it is put on the wall and keeps its speed; the wall does not hold it. */
    @Test
    void nodeOnItsWayBackKeepsItsSpeed() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        SlidingContact contact = contact(system, new SampleSystems.Ceiling(1, -20), 0.01);
        system.positions()[2] = 1.05;
        system.velocities()[2] = -30;
        system.project(0, H);
        assertThat(system.positions()[2]).isCloseTo(1, within(ROUNDING));
        assertThat(system.velocities()[2]).isEqualTo(-30);
        // Slower than the wall: it takes the wall's speed.
        system.positions()[2] = 1.05;
        system.velocities()[2] = -10;
        system.project(0, H);
        assertThat(system.velocities()[2]).isCloseTo(-20, within(ROUNDING));
        assertThat(contact.contactCount()).isEqualTo(1);
    }

    /**
     * Springs of the lung's base pull nodes off the pleura by more in a step than a wall that gives way would put back;
     * what adheres does not give way.
     */
    @Test
    void anAdheringNodeStaysHoweverHardItIsPulled() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        // 2 m/s more in every step, 20 times the return speed of a wall that holds from one side.
        double pull = 20 * SlidingContact.MAX_RETURN_SPEED / H * 0.1;
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, -pull}));
        system.add(SlidingContact.adhering(system.layout(), new int[] {0}, new SampleSystems.Ceiling(1, -20), 0.01));
        system.positions()[2] = 1;
        Integrator integrator = IntegratorKind.VERLET.create(system);
        for (int i = 0; i < 100; i++) {
            integrator.step(i * H, H);
            assertThat(system.positions()[2]).isCloseTo(1 - 20 * (i + 1) * H, within(1e-9));
        }
    }

    /** Inside of a sphere about the origin. */
    private record Bowl(double radius) implements ContactSurface {
        @Override
        public void tangentPlane(int node, double x, double y, double z, double[] plane, int at) {
            double r = Math.sqrt(x * x + y * y + z * z);
            plane[at] = -x / r;
            plane[at + 1] = -y / r;
            plane[at + 2] = -z / r;
            plane[at + 3] = -radius;
            plane[at + 4] = 0;
        }
    }

    /**
     * A node slides down a round bowl of 50 mm. Between refreshes the tangent plane lies outside the sphere by s²/2r, s
     * the way slid since.
     */
    @Test
    void nodeSlidesAlongACurvedWall() {
        double refresh = 0.01;
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.positions()[0] = 40;
        system.positions()[2] = -30;
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, -10}));
        system.setViscosity(0.2);
        SlidingContact contact = contact(system, new Bowl(50), refresh);
        Integrator integrator = IntegratorKind.VERLET.create(system);
        double fastest = 0;
        double deepest = 0;
        for (int i = 0; i < 10_000; i++) {
            integrator.step(i * H, H);
            double[] x = system.positions();
            double[] v = system.velocities();
            deepest = Math.max(deepest, Math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - 50);
            fastest = Math.max(fastest, Math.abs(v[0]));
        }
        assertThat(fastest).isGreaterThan(10);
        assertThat(deepest).isLessThan(Math.pow(2 * fastest * refresh, 2) / (2 * 50));
        assertThat(contact.contactCount()).isEqualTo(1);
        assertThat(system.positions()).containsExactly(new double[] {0, 0, -50}, within(0.01));
    }

    @Test
    void planesAreTakenAnewAfterTheIntervalAndWhenTimeGoesBack() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        SampleSystems.Ceiling wall = new SampleSystems.Ceiling(1, 0);
        contact(system, wall, 0.01);
        Integrator integrator = IntegratorKind.SYMPLECTIC_EULER.create(system);
        for (int i = 0; i < 100; i++) {
            integrator.step(i * H, H);
        }
        assertThat(wall.asked()).isEqualTo(10);
        // A step is done again, as after a divergence: its planes may belong to a state that was lost.
        integrator.step(99 * H, H);
        assertThat(wall.asked()).isEqualTo(11);
        integrator.step(95 * H, H);
        assertThat(wall.asked()).isEqualTo(12);
    }

    /** Before their plane is taken anew, node or wall go 15 mm; in one step 1.5 mm. */
    @ParameterizedTest
    @CsvSource({"1500, 0", "0, -1500", "700, -800"})
    void aNodeAndAWallThatComeNearUntilTheNextRefreshMeet(double nodeSpeed, double wallSpeed) {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        SlidingContact contact = contact(system, new SampleSystems.Ceiling(8, wallSpeed), 0.01);
        system.velocities()[2] = nodeSpeed;
        Integrator integrator = IntegratorKind.VERLET.create(system);
        for (int i = 0; i < 10; i++) {
            integrator.step(i * H, H);
            double wall = 8 + wallSpeed * (i + 1) * H;
            assertThat(system.positions()[2]).isLessThanOrEqualTo(wall + 1.5);
        }
        assertThat(contact.contactCount()).isEqualTo(1);
        assertThat(system.velocities()[2]).isCloseTo(wallSpeed, within(1e-9));
    }

    @Test
    void heldNodeAndSwitchedOffWallAreLeftAlone() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.positions()[2] = 3;
        SampleSystems.Ceiling wall = new SampleSystems.Ceiling(1, 0);
        SlidingContact contact = contact(system, wall, 0.01);
        system.setEnabled(contact, false);
        system.project(0, H);
        assertThat(wall.asked()).isZero();
        assertThat(system.positions()[2]).isEqualTo(3);
        system.setEnabled(contact, true);
        system.fix(0);
        system.project(0, H);
        assertThat(system.positions()[2]).isEqualTo(3);
        assertThat(contact.contactCount()).isZero();
    }

    /**
     * A second sweep finds the node on the wall, where the first has put it (to the bit, with numbers of few digits).
     */
    @Test
    void aNodeThatTheWallHoldsCountsInAnyNumberOfSweeps() {
        for (int sweeps : new int[] {1, 2, 5}) {
            double[] x = {0, 0, 0, 10, 0, 0, 20, 0, 0};
            NodeLayout layout = NodeLayout.natural(3);
            ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(3, 0.1), Workers.of(1));
            SlidingContact contact = contact(system, new SampleSystems.Ceiling(1, 0), 0.01);
            // With a constraint that is put right as a whole all are swept, whether they have moved a node or not.
            system.add(RigidLinks.singlePass(layout, new int[] {1}, new int[] {2}, x));
            system.setProjectionSweeps(sweeps);
            system.positions()[2] = 1.0625;
            system.project(0, H);
            assertThat(contact.contactCount()).isEqualTo(1);
            system.positions()[2] = 0.5;
            system.project(H, H);
            assertThat(contact.contactCount()).isZero();
        }
    }
}
