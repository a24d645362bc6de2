package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.scene.gl.FrameStatistics;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.Session;

@Timeout(120)
class RenderLoopTest {
    private static final int SIDE = 200;

    /** Receives the first picture. */
    private static final class FirstPicture implements RenderLoop.Listener {
        private final CompletableFuture<RenderedFrame> picture = new CompletableFuture<>();

        @Override
        public void onFrame(RenderedFrame drawn) {
            picture.complete(drawn);
        }

        @Override
        public void onReady(GraphicsInfo info) {}

        @Override
        public void onUnavailable(String sentence) {
            picture.completeExceptionally(new IllegalStateException(sentence));
        }
    }

    @Test
    void aPickIsAnsweredThoughThereIsNoScene() throws Exception {
        try (Session session = new Session(Scenario.defaults().with("resolution=low", "threads=1"))) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, new FirstPicture());
            loop.start();
            try {
                CompletableFuture<Optional<PickResult>> answer = new CompletableFuture<>();
                loop.pick(1, 1, null, surface -> 1, answer::complete);
                assertThat(answer.get(100, TimeUnit.SECONDS)).isEmpty();
            } finally {
                loop.close();
            }
        }
    }

    /** As with a lost context: each frame fails, and in the turns between them nothing is to be drawn. */
    @Test
    void aViewThatDrawsNothingAnyMoreSaysSo() throws Exception {
        FirstPicture never = new FirstPicture();
        try (Session session = new Session(Scenario.defaults().with("resolution=low", "threads=1"))) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, never);
            loop.start();
            try {
                for (int frame = 0; frame < 20; frame++) {
                    CountDownLatch failed = new CountDownLatch(1);
                    loop.runTask(gl -> {
                        failed.countDown();
                        throw new IllegalStateException("no current context");
                    });
                    assertThat(failed.await(100, TimeUnit.SECONDS)).isTrue();
                    Thread.sleep(20);
                }
                assertThat(never.picture)
                        .failsWithin(100, TimeUnit.SECONDS)
                        .withThrowableOfType(ExecutionException.class)
                        .withMessageContaining("The view stopped (no current context)");
            } finally {
                loop.close();
            }
        }
    }

    /** What is sent with the first picture keeps the user waiting. */
    @Test
    void meshesAreSentBeforeTheFirstPictureIsAskedFor() throws Exception {
        FirstPicture first = new FirstPicture();
        try (Session session = new Session(Scenario.defaults().with("resolution=low", "threads=1"))) {
            CompletableFuture<LiveScene> body = new CompletableFuture<>();
            RenderLoop loop = new RenderLoop(
                    session.live(),
                    () -> {
                        session.firstBody().ifPresent(body::complete);
                        return session.firstBody();
                    },
                    first);
            loop.start();
            try {
                LiveScene shown = body.get(100, TimeUnit.SECONDS);
                CountDownLatch prepared = new CountDownLatch(1);
                loop.runTask(gl -> prepared.countDown());
                assertThat(prepared.await(100, TimeUnit.SECONDS)).isTrue();
                Camera camera = Camera.of(AnatomicalView.ANTERIOR, SceneBounds.of(shown.surfaces()), 1);
                loop.request(new RenderLoop.Request(
                        shown,
                        camera,
                        SceneStyle.atlas(shown.surfaces()),
                        Optional.empty(),
                        Optional.empty(),
                        SIDE,
                        SIDE,
                        -1));
                FrameStatistics cost = first.picture.get(100, TimeUnit.SECONDS).cost();
                assertThat(cost.triangles()).isGreaterThan(10_000);
                assertThat(cost.bytesUploaded()).isZero();
            } finally {
                loop.close();
            }
        }
    }
}
