package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FrameTest {
    /** One surface that deforms, one that moves as a rigid body, and nodes. */
    private final Frame frame = new Frame(new Object(), new int[] {6, 0}, new boolean[] {false, true}, 6);

    @Test
    void aFrameIsFiniteUntilANumberThatIsDrawnIsNot() {
        assertThat(frame.isFinite()).isTrue();

        frame.positions(0)[4] = Float.NaN;
        assertThat(frame.isFinite()).as("a vertex").isFalse();
        frame.positions(0)[4] = 0;

        frame.pose(1)[3] = Float.POSITIVE_INFINITY;
        assertThat(frame.isFinite()).as("a bone").isFalse();
        frame.pose(1)[3] = 0;

        frame.nodes()[5] = Float.NEGATIVE_INFINITY;
        assertThat(frame.isFinite()).as("a node").isFalse();
        frame.nodes()[5] = 0;
        assertThat(frame.isFinite()).isTrue();
    }
}
