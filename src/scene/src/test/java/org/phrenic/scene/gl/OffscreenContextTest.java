package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;

import com.jogamp.common.util.VersionNumber;
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

    /** JOGL gives contexts of OpenGL 3.1 and 3.2 as well; their drivers compile none of the shaders. */
    @Test
    void anOldDriverIsToldInOneSentence() {
        assertThat(OffscreenContext.obstacle(new VersionNumber(3, 2, 0)))
                .contains("No pictures can be made here: the graphics driver has no OpenGL 3.3, it has 3.2");
        assertThat(OffscreenContext.obstacle(new VersionNumber(3, 3, 0))).isEmpty();
        assertThat(OffscreenContext.obstacle(new VersionNumber(4, 1, 0))).isEmpty();
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
