package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.scene.gl.FrameStatistics;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Surface;
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
        try (Session session =
                new Session(Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1"))) {
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
        try (Session session =
                new Session(Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1"))) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, never);
            loop.start();
            try {
                for (int frame = 0; frame < 20; frame++) {
                    CountDownLatch failed = new CountDownLatch(1);
                    loop.runTask(
                            gl -> {
                                failed.countDown();
                                throw new IllegalStateException("no current context");
                            },
                            () -> {});
                    assertThat(failed.await(100, TimeUnit.SECONDS)).isTrue();
                    Thread.sleep(20);
                }
                assertThat(never.picture)
                        .failsWithin(100, TimeUnit.SECONDS)
                        .withThrowableOfType(ExecutionException.class)
                        .withMessageContaining("The view stopped (no current context)");
                CountDownLatch told = new CountDownLatch(1);
                loop.runTask(gl -> {}, told::countDown);
                assertThat(told.await(100, TimeUnit.SECONDS))
                        .as("that nothing is drawn")
                        .isTrue();
            } finally {
                loop.close();
            }
        }
    }

    /** A second scene may settle before the first has run. */
    @Test
    void anotherBodyAtRestIsShownInsteadOfTheOneBefore() throws Exception {
        Scenario small = Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1");
        BlockingQueue<RenderedFrame> pictures = new LinkedBlockingQueue<>();
        try (Session session = new Session(small)) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, new RenderLoop.Listener() {
                @Override
                public void onFrame(RenderedFrame drawn) {
                    pictures.add(drawn);
                }

                @Override
                public void onReady(GraphicsInfo info) {}

                @Override
                public void onUnavailable(String sentence) {}
            });
            loop.start();
            try {
                LiveScene man = atRest(small);
                LiveScene woman = atRest(small.with("anatomy=virtual/adult-female"));
                RenderLoop.Request first = request(man);
                loop.request(first);
                RenderedFrame ofMan = pictures.poll(100, TimeUnit.SECONDS);
                assertThat(ofMan).isNotNull();
                loop.request(request(woman));
                RenderedFrame ofWoman = pictures.poll(100, TimeUnit.SECONDS);
                assertThat(ofWoman).isNotNull();
                assertThat(ofWoman.cost().bytesUploaded()).as("another body").isPositive();
                assertThat(ofWoman.cost().triangles()).isNotEqualTo(ofMan.cost().triangles());
                assertThat(pick(loop, first)).as("in the body before").isEmpty();
                assertThat(pick(loop, request(woman))).isPresent();
                CompletableFuture<Optional<PickResult>> answer = new CompletableFuture<>();
                loop.pick(SIDE / 2.0, SIDE / 2.0, request(woman), RenderLoopTest::lost, answer::complete);
                assertThat(answer.get(100, TimeUnit.SECONDS))
                        .as("the answer to a pick that fails")
                        .isEmpty();
            } finally {
                loop.close();
            }
        }
    }

    private static double lost(Surface surface) {
        throw new IllegalStateException("lost " + surface.name());
    }

    private static LiveScene atRest(Scenario scenario) {
        return LiveScene.atRest(scenario, SimulationRun.loadThorax(scenario));
    }

    private static RenderLoop.Request request(LiveScene of) {
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, Surface.bounds(of.surfaces()), 1);
        SceneStyle style = SceneStyle.atlas(of.surfaces());
        return new RenderLoop.Request(of, camera, style, Optional.empty(), Optional.empty(), SIDE, SIDE, -1);
    }

    private static Optional<PickResult> pick(RenderLoop loop, RenderLoop.Request at) throws Exception {
        CompletableFuture<Optional<PickResult>> answer = new CompletableFuture<>();
        loop.pick(SIDE / 2.0, SIDE / 2.0, at, surface -> 1, answer::complete);
        return answer.get(100, TimeUnit.SECONDS);
    }

    /** As without memory for a moment: the view is drawn and the picture written when there is some again. */
    @Test
    void aBodyThatCannotBeSetUpAtOnceIsSetUpLater() throws Exception {
        Scenario small = Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1");
        FirstPicture first = new FirstPicture();
        try (Session session = new Session(small)) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, first);
            LiveScene body = atRest(small);
            AtomicInteger attempts = new AtomicInteger();
            CompletableFuture<Boolean> written = new CompletableFuture<>();
            LiveScene late = new LiveScene(
                    small,
                    body.surfaces(),
                    body.overlays(),
                    () -> {
                        if (attempts.getAndIncrement() == 0) {
                            loop.runTask(gl -> written.complete(true), () -> {});
                        }
                        if (attempts.get() < 4) {
                            throw new OutOfMemoryError("frame");
                        }
                        return body.newFrame().get();
                    },
                    body.nodes(),
                    body.body(),
                    body.id());
            loop.start();
            try {
                loop.request(request(late));
                assertThat(first.picture.get(100, TimeUnit.SECONDS).cost().triangles())
                        .isGreaterThan(10_000);
                assertThat(written.get(100, TimeUnit.SECONDS)).isTrue();
                assertThat(attempts).hasValue(4);
            } finally {
                loop.close();
            }
        }
    }

    /** As without memory for its buffers: nothing else asks for it in a pause, which may be long. */
    @ParameterizedTest
    @ValueSource(ints = {1, 21})
    void aPictureThatFailsIsDrawnAgain(int failures) throws Exception {
        Scenario small = Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1");
        FirstPicture first = new FirstPicture();
        AtomicInteger attempts = new AtomicInteger();
        try (Session session = new Session(small)) {
            RenderLoop loop = new RenderLoop(session.live(), Optional::empty, first);
            loop.setMarkSource(() -> {
                if (attempts.getAndIncrement() < failures) {
                    throw new OutOfMemoryError("buffer");
                }
                return Optional.empty();
            });
            loop.start();
            try {
                loop.request(request(atRest(small)));
                assertThat(first.picture.get(100, TimeUnit.SECONDS)).isNotNull();
            } finally {
                loop.close();
            }
        }
    }

    /** What is sent with the first picture keeps the user waiting. */
    @Test
    void meshesAreSentBeforeTheFirstPictureIsAskedFor() throws Exception {
        FirstPicture first = new FirstPicture();
        Scenario small = Scenario.defaults().with("resolution=low", "mesh_vertices=2000", "threads=1");
        try (Session session = new Session(small)) {
            LiveScene shown = atRest(small);
            RenderLoop loop = new RenderLoop(session.live(), () -> Optional.of(shown), first);
            loop.start();
            try {
                CountDownLatch prepared = new CountDownLatch(1);
                loop.runTask(gl -> prepared.countDown(), () -> {});
                assertThat(prepared.await(100, TimeUnit.SECONDS)).isTrue();
                loop.request(request(shown));
                FrameStatistics cost = first.picture.get(100, TimeUnit.SECONDS).cost();
                assertThat(cost.triangles()).isGreaterThan(10_000);
                assertThat(cost.bytesUploaded()).isZero();
            } finally {
                loop.close();
            }
        }
    }
}
