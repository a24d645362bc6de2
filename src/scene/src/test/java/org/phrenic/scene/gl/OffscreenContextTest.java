package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.scene.SceneFixture;

/** A context without a window. */
class OffscreenContextTest {
    @Test
    void opensAgainAndAgainAndSaysWhatDraws() {
        for (int i = 0; i < 3; i++) {
            try (OffscreenContext offscreen = SceneFixture.openOrSkip()) {
                assertThat(offscreen.info().version()).isNotBlank();
                assertThat(offscreen.info().maxSize()).isGreaterThanOrEqualTo(2048);
            }
        }
    }

    @Test
    void aPreparedContextServesOneOpening() {
        SceneFixture.openOrSkip().close();
        OffscreenContext.prepare();
        try (OffscreenContext prepared = SceneFixture.openOrSkip();
                OffscreenContext other = SceneFixture.openOrSkip()) {
            assertThat(prepared).isNotSameAs(other);
            assertThat(prepared.info().version()).isEqualTo(other.info().version());
        }
    }

    @Test
    void onlyADisplayThatAnswersCounts() {
        assertThat(DisplayServer.isReachable(null)).isFalse();
        assertThat(DisplayServer.isReachable("")).isFalse();
        assertThat(DisplayServer.isReachable("nonsense")).isFalse();
        assertThat(DisplayServer.isReachable(":nonsense")).isFalse();
        assertThat(DisplayServer.isReachable(":54321"))
                .as("no server has this number")
                .isFalse();
    }
}
