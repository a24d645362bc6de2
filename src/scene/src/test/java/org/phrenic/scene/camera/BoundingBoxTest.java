package org.phrenic.scene.camera;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BoundingBoxTest {
    /** A trunk; the diagonal is 608 mm. */
    private static final double[] TRUNK = {-180, -120, -200, 180, 120, 220};

    @Test
    void organsOfABodyLeaveItWhereTheCameraLooks() {
        assertThat(BoundingBox.areAlike(TRUNK, TRUNK)).isTrue();
        assertThat(BoundingBox.areAlike(TRUNK, new double[] {-180, -120, -300, 180, 120, 220}))
                .isTrue();
    }

    @Test
    void aBodyThatIsElsewhereOrLargerIsAnother() {
        assertThat(BoundingBox.areAlike(TRUNK, new double[] {20, -120, -200, 380, 120, 220}))
                .as("200 mm to the left")
                .isFalse();
        assertThat(BoundingBox.areAlike(TRUNK, new double[] {-180, -200, -120, 180, 220, 120}))
                .as("turned about its middle, where the camera looks")
                .isTrue();
        assertThat(BoundingBox.areAlike(TRUNK, new double[] {-180, -120, 880, 180, 120, 1300}))
                .as("another origin")
                .isFalse();
        assertThat(BoundingBox.areAlike(TRUNK, new double[] {-360, -240, -400, 360, 240, 440}))
                .as("twice the spacing")
                .isFalse();
    }
}
