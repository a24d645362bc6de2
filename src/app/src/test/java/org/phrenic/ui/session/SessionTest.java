package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;

/** The first picture comes before the first scene where it is asked to. */
class SessionTest {
    private static final long PATIENCE_S = 60;
    /** The small scene is assembled in less. */
    private static final long UNDISTURBED_MS = 2_000;

    @Test
    void theFirstSceneWaitsForTheFirstPicture() throws Exception {
        Scenario small = Scenario.defaults().with("resolution=low", "lungs=off", "sternum=off", "liver=false");
        CountDownLatch body = new CountDownLatch(1);
        CountDownLatch scene = new CountDownLatch(1);
        Session[] made = new Session[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = new Session(small, true);
            made[0].addListener(new Session.Listener() {
                @Override
                public void onBody(LiveScene atRest) {
                    body.countDown();
                }

                @Override
                public void onScene(LiveScene running) {
                    scene.countDown();
                }
            });
        });
        try (Session session = made[0]) {
            assertThat(body.await(PATIENCE_S, TimeUnit.SECONDS))
                    .as("a body to draw")
                    .isTrue();
            assertThat(scene.await(UNDISTURBED_MS, TimeUnit.MILLISECONDS))
                    .as("a scene before the picture")
                    .isFalse();
            session.endPictureWait();
            assertThat(scene.await(PATIENCE_S, TimeUnit.SECONDS))
                    .as("a scene after the picture")
                    .isTrue();
        }
    }
}
