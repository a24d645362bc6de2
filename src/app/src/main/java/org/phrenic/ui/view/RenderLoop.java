package org.phrenic.ui.view;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.phrenic.scene.AccessMapField;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.scene.camera.Picker;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Draws the scene on a thread of its own, so that neither the window nor the simulation waits for a frame: one is drawn
 * when the simulation has a new one, or camera or style change, as often and as finely as {@link DrawingPace} says. A
 * coarse frame is drawn again at full resolution when nothing moves. All OpenGL calls are made on this thread.
 */
public final class RenderLoop implements AutoCloseable {
    /**
     * What the view should show.
     *
     * @param reference surface from which distances are measured
     * @param accessColours map that colours the skin
     * @param width of the frame, device pixels
     * @param height of the frame, device pixels
     * @param historyFrame recorded frame; -1 for the present
     */
    record Request(
            LiveScene scene,
            Camera camera,
            SceneStyle style,
            Optional<DistanceField> reference,
            Optional<AccessMapField> accessColours,
            int width,
            int height,
            int historyFrame) {}

    /** Called on the render thread. */
    interface Listener {
        void onFrame(RenderedFrame picture);

        /** The renderer is ready. */
        void onReady(GraphicsInfo info);

        /** Nothing can be drawn on this machine, for this reason. */
        void onUnavailable(String sentence);
    }

    /** Time after the last frame from which a coarse one is drawn again, ns. */
    private static final long AT_REST_NS = 300_000_000;

    private static final int PREPARED_PIXELS = 64;

    private static final System.Logger LOG = System.getLogger(RenderLoop.class.getName());

    private final LiveRun live;
    private final Supplier<Optional<LiveScene>> firstBody;
    private final Listener listener;
    private volatile Supplier<Optional<NeedleMarkers>> markSource = Optional::empty;
    private final Thread thread = new Thread(this::run, "phrenic-view");
    private final ReentrantLock lock = new ReentrantLock();
    private final RenderTasks tasks = new RenderTasks();
    private final ImagePool imagePool = new ImagePool();
    private Request requested;
    private long version;
    private boolean closed;
    private LiveScene scene;
    private Renderer renderer;
    private Picker picker;
    private Frame frame;
    private final DistanceColours distances = new DistanceColours();
    private Optional<NeedleMarkers> shownMarks = Optional.empty();
    private String shownTime = "";
    private Optional<AccessMapField> shownAccess = Optional.empty();
    private int historyFrame = -1;
    private long drawnVersion;
    private final DrawingPace pace = DrawingPace.ofProcess();
    private boolean drawnSharp;
    private long drawnNs;
    private long countedScene;

    /** @param firstBody the body that is shown first, once it is there; called on the render thread */
    RenderLoop(LiveRun live, Supplier<Optional<LiveScene>> firstBody, Listener listener) {
        this.live = live;
        this.firstBody = firstBody;
        this.listener = listener;
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Requests a frame; the last request counts. */
    void request(Request wanted) {
        update(() -> {
            requested = wanted;
            version++;
        });
    }

    void setMarkSource(Supplier<Optional<NeedleMarkers>> with) {
        update(() -> markSource = with);
    }

    /** Runs a task on the render thread; after the end of that, {@code otherwise} on any thread. */
    void runTask(Consumer<OffscreenContext> what, Runnable otherwise) {
        tasks.add(what, otherwise);
        LockSupport.unpark(thread);
    }

    /** Draws the present frame at any size; {@code done} gets it on the render thread, unless it cannot be drawn. */
    void snapshot(Camera camera, SceneStyle style, int width, int height, SnapshotListener done) {
        Consumer<OffscreenContext> drawing = gl -> {
            if (renderer != null) {
                SceneStyle marked =
                        NeedleMarkers.apply(shownMarks, renderer, style).withSamples(SceneStyle.SMOOTH_SAMPLES);
                done.drawn(gl.render(renderer, frame, camera, marked, width, height), shownTime, shownMarks);
            }
        };
        runTask(drawing, () -> {});
    }

    /** Picks the surface under a pixel; {@code done} gets it on the render thread, or nothing if it cannot be. */
    void pick(
            double px, double py, Request at, ToDoubleFunction<Surface> opacity, Consumer<Optional<PickResult>> done) {
        Consumer<OffscreenContext> picking = gl -> {
            Optional<PickResult> found = Optional.empty();
            try {
                if (scene != null && scene.id() == at.scene().id()) {
                    picker = picker == null ? new Picker(scene.surfaces()) : picker;
                    double[] ray = at.camera().ray(px, py, at.width(), at.height());
                    found = picker.pick(frame, ray, at.style().clip(), opacity);
                }
            } finally {
                done.accept(found);
            }
        };
        runTask(picking, () -> done.accept(Optional.empty()));
    }

    private void update(Runnable what) {
        lock.lock();
        try {
            what.run();
        } finally {
            lock.unlock();
        }
        LockSupport.unpark(thread);
    }

    private void run() {
        try (OffscreenContext gl = OffscreenContext.open()) {
            LOG.log(System.Logger.Level.INFO, "Pictures by {0}", gl.info().description());
            listener.onReady(gl.info());
            loop(gl);
        } catch (NoGraphicsException e) {
            listener.onUnavailable(e.getMessage());
        } catch (RuntimeException | OutOfMemoryError | LinkageError e) {
            LOG.log(System.Logger.Level.ERROR, "The view stopped", e);
            listener.onUnavailable("The view stopped (" + e.getMessage() + "); everything else goes on.");
        } finally {
            tasks.end();
        }
    }

    private void loop(OffscreenContext gl) {
        DrawingFailures failures = new DrawingFailures();
        while (true) {
            Request wanted;
            long now;
            lock.lock();
            try {
                wanted = requested;
                now = version;
                if (closed) {
                    return;
                }
            } finally {
                lock.unlock();
            }
            long begun = System.nanoTime();
            boolean busy = false;
            try {
                busy = turn(gl, wanted, now);
                if (busy) {
                    failures.end();
                }
            } catch (RuntimeException | OutOfMemoryError e) {
                // A frame or a task that fails does not end the view.
                if (failures.add(now + tasks.begun())) {
                    LOG.log(System.Logger.Level.WARNING, "A frame was not drawn", e);
                }
                if (failures.areTooMany()) {
                    throw e;
                }
            }
            LockSupport.parkNanos(
                    busy ? Math.max(0, pace.intervalNs() - (System.nanoTime() - begun)) : failures.restNs());
        }
    }

    /** Runs a task, if one waits, and draws if anything has changed; returns whether anything was done. */
    private boolean turn(OffscreenContext gl, Request wanted, long now) {
        boolean asked = tasks.isAnyWaiting();
        if (wanted != null) {
            setScene(gl, wanted.scene());
        } else if (scene == null) {
            firstBody.get().ifPresent(body -> prepare(gl, body));
        }
        if (asked) {
            tasks.runNext(gl);
        }
        Optional<BufferedImage> canvas = wanted != null && wanted.width() > 0 && wanted.height() > 0
                ? imagePool.acquire(wanted.width(), wanted.height())
                : Optional.empty();
        return canvas.filter(image -> draw(gl, wanted, now, image)).isPresent() || asked;
    }

    private boolean draw(OffscreenContext gl, Request wanted, long now, BufferedImage canvas) {
        long begunNs = System.nanoTime();
        boolean drawn = false;
        boolean asAsked = now != drawnVersion;
        drawnVersion = -1; // until it is drawn
        try {
            drawn = draw(gl, wanted, asAsked, canvas);
            drawnVersion = now;
        } finally {
            if (!drawn) {
                imagePool.release(canvas);
            }
        }
        if (drawn) {
            noteCost(begunNs, gl.info().software());
        }
        return drawn;
    }

    /** The first frame of a scene is not counted: it also uploads the scene and compiles shaders. */
    private void noteCost(long begunNs, boolean software) {
        drawnNs = System.nanoTime();
        if (scene.id() == countedScene) {
            pace.drawn((drawnNs - begunNs) * 1e-6, DrawingPace.Demand.of(live), software, drawnNs * 1e-9);
        }
        countedScene = scene.id();
    }

    void release(RenderedFrame old) {
        imagePool.release(old.image());
    }

    /** Sets a scene up; one that cannot be, for lack of memory, is set up at the next turn. */
    private void setScene(OffscreenContext gl, LiveScene wanted) {
        if (scene == null || scene.id() != wanted.id()) {
            scene = null;
            if (renderer != null) {
                gl.release(renderer);
                renderer = null;
            }
            List<Surface> all = new ArrayList<>(wanted.surfaces());
            all.addAll(NeedleMarkers.surfaces());
            frame = wanted.newFrame().get();
            renderer = new Renderer(all, wanted.overlays());
            shownAccess = Optional.empty();
            picker = null;
            scene = wanted;
        }
    }

    /** Draws a body out of sight before a picture is asked for: meshes are sent and shaders compiled meanwhile. */
    private void prepare(OffscreenContext gl, LiveScene body) {
        setScene(gl, body);
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, Surface.bounds(body.surfaces()), 1);
        gl.render(renderer, frame, camera, SceneStyle.atlas(body.surfaces()), PREPARED_PIXELS, PREPARED_PIXELS);
    }

    private boolean draw(OffscreenContext gl, Request wanted, boolean asAsked, BufferedImage canvas) {
        boolean fresh = wanted.historyFrame() < 0
                ? live.copyNewestFrame(frame)
                : wanted.historyFrame() != historyFrame && takeHistoryFrame(wanted.historyFrame());
        historyFrame = wanted.historyFrame();
        Optional<NeedleMarkers> now = historyFrame < 0 ? markSource.get() : Optional.empty();
        boolean same = now.equals(shownMarks);
        shownMarks = now;
        boolean rests = !fresh && !asAsked && same;
        boolean sharpen = rests && !drawnSharp && isAtRest();
        if (rests && !sharpen) {
            return false;
        }
        if (wanted.style().field() == ColourField.DISTANCE) {
            wanted.reference().ifPresent(from -> distances.colour(renderer, scene.id(), frame, from, wanted.style()));
        }
        if (!wanted.accessColours().equals(shownAccess)) {
            wanted.accessColours().ifPresent(field -> field.upload(renderer));
            shownAccess = wanted.accessColours();
        }
        boolean card = !gl.info().software();
        drawnSharp = sharpen || card;
        double resolution = drawnSharp ? 1 : pace.resolution();
        // Depth peeling takes four times the pixels for samples.
        boolean peeled = wanted.style().quality().transparency() == Transparency.PEELED;
        SceneStyle style = NeedleMarkers.apply(shownMarks, renderer, wanted.style())
                .withResolution(resolution)
                .withSamples(drawnSharp && (card || !peeled) ? SceneStyle.SMOOTH_SAMPLES : 0);
        gl.run(context -> {
            renderer.draw(context, frame, wanted.camera(), style, wanted.width(), wanted.height());
            renderer.readPixels(context, canvas);
        });
        String phase = historyFrame < 0 ? live.status().phaseLabel() : "recorded";
        shownTime = scene.isAtRest() ? "" : Annotations.timestamp(frame.timeS(), phase);
        listener.onFrame(new RenderedFrame(
                canvas, wanted, frame.step(), shownTime, shownMarks, renderer.statistics(), resolution));
        return true;
    }

    private boolean isAtRest() {
        return !scene.isAtRest() && !live.isPlaying() && System.nanoTime() - drawnNs > AT_REST_NS;
    }

    private boolean takeHistoryFrame(int index) {
        RunHistory history = live.history();
        return history != null && history.frame(index, frame);
    }

    /** Ends the thread and releases the OpenGL context. */
    @Override
    public void close() {
        update(() -> closed = true);
    }
}
