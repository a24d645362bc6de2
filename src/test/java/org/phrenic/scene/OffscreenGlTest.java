package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A context without a window. */
class OffscreenGlTest {
    @Test
    void opensAgainAndAgainAndSaysWhatDraws() {
        for (int i = 0; i < 3; i++) {
            try (OffscreenGl offscreen = SceneFixture.openOrSkip()) {
                assertThat(offscreen.info().version()).isNotBlank();
                assertThat(offscreen.info().maxSize()).isGreaterThanOrEqualTo(2048);
            }
        }
    }

    @Test
    void onlyADisplayThatAnswersCounts() {
        assertThat(DisplayServer.answers(null)).isFalse();
        assertThat(DisplayServer.answers("")).isFalse();
        assertThat(DisplayServer.answers("nonsense")).isFalse();
        assertThat(DisplayServer.answers(":nonsense")).isFalse();
        assertThat(DisplayServer.answers(":54321"))
                .as("no server has this number")
                .isFalse();
    }
}
