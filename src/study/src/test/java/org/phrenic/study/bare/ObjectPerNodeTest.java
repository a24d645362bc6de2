package org.phrenic.study.bare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import org.junit.jupiter.api.Test;

/** The baseline of the benchmarks does the engine's work: a ratio of speeds means nothing otherwise. */
class ObjectPerNodeTest {
    private static final double RELATIVE = 1e-9;

    @Test
    void textbookAndEngineMoveTheDomeAlike() {
        BareScene scene = Domes.scene(24, false);
        ObjectPerNode objects = new ObjectPerNode(scene, BareSettings.DEFAULT);
        try (BareWorkload engine = new BareWorkload(scene, BareSettings.DEFAULT)) {
            engine.advance(BareWorkload.CHECKED_STEPS);
            for (int i = 0; i < BareWorkload.CHECKED_STEPS; i++) {
                objects.step();
            }
            assertThat(objects.meanDz()).isNegative();
            assertThat(engine.meanDz()).isCloseTo(objects.meanDz(), withPercentage(100 * RELATIVE));
        }
    }
}
