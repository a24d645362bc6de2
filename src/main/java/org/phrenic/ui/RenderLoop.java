package org.phrenic.ui;

import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.phrenic.scene.AccessField;
import org.phrenic.scene.Annotations;
import org.phrenic.scene.Camera;
import org.phrenic.scene.ColourField;
import org.phrenic.scene.DistanceField;
import org.phrenic.scene.GraphicsInfo;
import org.phrenic.scene.NeedleMarks;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.OffscreenGl;
import org.phrenic.scene.Pick;
import org.phrenic.scene.Picker;
import org.phrenic.scene.Renderer;
import org.phrenic.scene.SceneStyle;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;
import org.phrenic.simulation.live.History;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;

/**
 * Draws the scene on a thread of its own, so that neither the window nor the simulation waits for a picture: a picture is drawn when there is a new frame, or when camera or style changed, and at most
 * {@value #MOST_PER_S} times a second. Where the processor draws, pictures come less often while the simulation cannot keep its pace, down to one in {@value #SLOWEST_MS} ms. Everything about OpenGL stays on this thread.
 */
final class RenderLoop implements AutoCloseable {
    /** Told what was drawn; on the drawing thread. */
    interface Viewer {
        void drawn(Picture picture);

        /** Pictures can be made, by this. */
        void ready(GraphicsInfo info);

        /** No picture can be made on this machine, and why. */
        void impossible(String sentence);
    }

    /** Of what the distances are that the renderer holds. */
    private record Measured(long scene, long step, DistanceField from, String structure) {}

    /** What is shown besides the scene; asked on the drawing thread before each picture. */
    interface Marks {
        Optional<NeedleMarks> now();
    }

    private static final int MOST_PER_S = 60;
    private static final long LEAST_NS = 1_000_000_000L / MOST_PER_S;
    private static final long NEWS_NS = 5_000_000;
    private static final long SLOWEST_MS = 80;
    private static final long SLOWER_NS = 4_000_000;
    private static final long FASTER_NS = 500_000;
    private static final System.Logger LOG = System.getLogger(RenderLoop.class.getName());

    private final LiveRun live;
    private final Viewer viewer;
    private volatile Marks marks = Optional::empty;
    private final Thread thread = new Thread(this::run, "phrenic-view");
    private final ReentrantLock lock = new ReentrantLock();
    private final Queue<Consumer<OffscreenGl>> tasks = new ArrayDeque<>();
    private final Canvases canvases = new Canvases();
    private Wanted asked;
    private long version;
    private boolean closed;

    private LiveScene scene;
    private Renderer renderer;
    private Picker picker;
    private Frame frame;
    private Measured measured;
    private Optional<NeedleMarks> marked = Optional.empty();
    private Optional<AccessField> coloured = Optional.empty();
    private int scrubbed = -1;
    private long drawn;
    private long leastNs = LEAST_NS;

    RenderLoop(LiveRun live, Viewer viewer) {
        this.live = live;
        this.viewer = viewer;
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Asks for another picture; of several asked for in a row the last counts. */
    void show(Wanted wanted) {
        tell(() -> {
            asked = wanted;
            version++;
        });
    }

    /** From now on shows what this says besides the scene. */
    void mark(Marks with) {
        tell(() -> marks = with);
    }

    /** Does something with what draws, on the drawing thread. */
    void work(Consumer<OffscreenGl> what) {
        tell(() -> tasks.add(what));
    }

    /** Makes a picture of the frame at hand of any size; {@code done} is told on the drawing thread. */
    void still(Camera camera, SceneStyle style, int width, int height, Consumer<BufferedImage> done) {
        tell(() -> tasks.add(gl -> {
            if (renderer != null) {
                done.accept(
                        gl.picture(renderer, frame, camera, NeedleMarks.place(marked, renderer, style), width, height));
            }
        }));
    }

    /** Looks for what lies under a pixel, as opaque as it is said to be; {@code done} is told on the drawing thread. */
    void pick(double px, double py, Wanted at, ToDoubleFunction<Surface> opacity, Consumer<Optional<Pick>> done) {
        tell(() -> tasks.add(gl -> {
            if (scene != null && scene.id() == at.scene().id()) {
                if (picker == null) {
                    picker = new Picker(scene.surfaces());
                }
                double[] sight = at.camera().ray(px, py, at.width(), at.height());
                done.accept(picker.pick(frame, sight, opacity));
            }
        }));
    }

    private void tell(Runnable what) {
        lock.lock();
        try {
            what.run();
        } finally {
            lock.unlock();
        }
        LockSupport.unpark(thread);
    }

    private void run() {
        try (OffscreenGl gl = OffscreenGl.open()) {
            LOG.log(System.Logger.Level.INFO, "Pictures by {0}", gl.info());
            viewer.ready(gl.info());
            loop(gl);
        } catch (NoGraphicsException e) {
            viewer.impossible(e.getMessage());
        } catch (RuntimeException e) {
            LOG.log(System.Logger.Level.ERROR, "The view stopped", e);
            viewer.impossible("The view stopped (" + e.getMessage() + "); everything else goes on.");
        }
    }

    private void loop(OffscreenGl gl) {
        while (true) {
            Wanted wanted;
            long now;
            Consumer<OffscreenGl> task;
            lock.lock();
            try {
                wanted = asked;
                now = version;
                task = tasks.poll();
                if (closed) {
                    return;
                }
            } finally {
                lock.unlock();
            }
            long begun = System.nanoTime();
            if (wanted != null) {
                enter(gl, wanted.scene());
            }
            boolean busy = task != null;
            if (busy) {
                task.accept(gl);
            }
            if (wanted != null && wanted.width() > 0 && wanted.height() > 0) {
                Optional<BufferedImage> canvas = canvases.take(wanted.width(), wanted.height());
                if (canvas.isPresent()) {
                    busy |= draw(gl, wanted, now != drawn, canvas.get());
                    drawn = now;
                }
            }
            if (busy) {
                pace(gl.info());
            }
            rest(busy ? Math.max(0, leastNs - (System.nanoTime() - begun)) : NEWS_NS);
        }
    }

    /** Where pictures cost the simulation its time, they become rarer at once and slowly more often again. */
    private void pace(GraphicsInfo info) {
        long wanted = leastNs + (live.isBehind() ? SLOWER_NS : -FASTER_NS);
        leastNs = info.software() ? Math.max(LEAST_NS, Math.min(SLOWEST_MS * 1_000_000, wanted)) : LEAST_NS;
    }

    /** Takes back the image of a picture that is no longer shown. */
    void giveBack(Picture old) {
        canvases.giveBack(old.image());
    }

    /** Takes over the scene that is asked for, before anything is drawn of it or looked for in it. */
    private void enter(OffscreenGl gl, LiveScene wanted) {
        if (scene == null || scene.id() != wanted.id()) {
            scene = wanted;
            if (renderer != null) {
                gl.release(renderer);
            }
            List<Surface> all = new ArrayList<>(scene.surfaces());
            all.addAll(NeedleMarks.surfaces());
            renderer = new Renderer(all, scene.overlays());
            coloured = Optional.empty();
            picker = null;
            frame = scene.newFrame().get();
        }
    }

    /** Draws if there is anything new. */
    private boolean draw(OffscreenGl gl, Wanted wanted, boolean asAsked, BufferedImage canvas) {
        boolean fresh = wanted.scrubbed() < 0
                ? live.takeFrame(frame)
                : wanted.scrubbed() != scrubbed && recorded(wanted.scrubbed());
        scrubbed = wanted.scrubbed();
        Optional<NeedleMarks> now = scrubbed < 0 ? marks.now() : Optional.empty();
        boolean same = now.equals(marked);
        marked = now;
        if (!fresh && !asAsked && same) {
            canvases.giveBack(canvas);
            return false;
        }
        if (wanted.style().field() == ColourField.DISTANCE) {
            wanted.distances().ifPresent(field -> measure(field, wanted.style().fieldOn()));
        }
        if (!wanted.access().equals(coloured)) {
            coloured = wanted.access();
            coloured.ifPresent(field -> field.colour(renderer));
        }
        SceneStyle style = NeedleMarks.place(marked, renderer, wanted.style());
        gl.run(context -> {
            renderer.draw(context, frame, wanted.camera(), style, wanted.width(), wanted.height());
            renderer.read(context, canvas);
        });
        viewer.drawn(new Picture(canvas, wanted, frame.step(), moment(wanted), marked, renderer.cost()));
        return true;
    }

    /** Colours a structure by its distances, unless they are those of the last picture. */
    private void measure(DistanceField field, String structure) {
        Measured now = new Measured(scene.id(), frame.step(), field, structure);
        if (!now.equals(measured)) {
            field.colour(renderer, frame, structure);
            measured = now;
        }
    }

    private String moment(Wanted wanted) {
        return Annotations.moment(
                frame.timeS(), wanted.scrubbed() < 0 ? live.status().phaseLabel() : "recorded");
    }

    private boolean recorded(int index) {
        History history = live.history();
        return history != null && history.frame(index, frame);
    }

    /** Waits so long, or until there is something to do; {@link #tell} wakes it. */
    private static void rest(long ns) {
        LockSupport.parkNanos(ns);
    }

    /** Ends the thread; what it held of the driver goes with it. */
    @Override
    public void close() {
        tell(() -> closed = true);
    }
}
