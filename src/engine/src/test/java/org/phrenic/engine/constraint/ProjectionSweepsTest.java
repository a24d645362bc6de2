package org.phrenic.engine.constraint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * A link of 2 mm on the z axis whose upper node a floor at z = 0 holds up: floor and link each break what the other put
 * right.
 */
class ProjectionSweepsTest {
    private static final ContactSurface FLOOR = (node, x, y, z, plane, at) -> {
        plane[at] = 0;
        plane[at + 1] = 0;
        plane[at + 2] = 1;
        plane[at + 3] = 0;
        plane[at + 4] = 0;
    };

    private static double linkError(int sweeps) {
        double[] x = {0, 0, 0, 0, 0, -2};
        NodeLayout layout = NodeLayout.morton(x);
        try (Workers workers = Workers.of(1)) {
            ParticleSystem system = new ParticleSystem(layout, x, new double[] {1, 1}, workers);
            RigidLinks link = RigidLinks.gaussSeidel(layout, new int[] {0}, new int[] {1}, x, 1e-12, 10);
            system.add(link);
            system.add(new SlidingContact(layout, new int[] {0}, FLOOR, 0));
            system.setProjectionSweeps(sweeps);
            // The lower node has sunk by 0.1 mm.
            system.positions()[3 * layout.internal(1) + 2] = -2.1;
            system.project(0.01, 0.01);
            return link.error(system);
        }
    }

    @Test
    void eachSweepHalvesWhatTheLastOneLeft() {
        double first = linkError(1);
        // The link takes half of 0.1 mm from each node, the floor gives its half back: 0.05 of 2 mm.
        assertThat(first).isCloseTo(0.025, org.assertj.core.api.Assertions.within(1e-9));
        for (int sweeps = 2; sweeps < 10; sweeps++) {
            assertThat(linkError(sweeps)).isBetween(0.49 * linkError(sweeps - 1), 0.51 * linkError(sweeps - 1));
        }
    }

    @Test
    void noSweepAtAllIsRefused() {
        double[] x = {0, 0, 0};
        try (Workers workers = Workers.of(1)) {
            ParticleSystem system = new ParticleSystem(NodeLayout.morton(x), x, new double[] {1}, workers);
            assertThatThrownBy(() -> system.setProjectionSweeps(0))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("found 0");
        }
    }
}
