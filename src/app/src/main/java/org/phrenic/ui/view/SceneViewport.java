package org.phrenic.ui.view;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.BodyName;
import org.phrenic.ui.session.Session;

/**
 * The 3D view. A {@link RenderLoop} draws frames into a framebuffer on another thread, at the resolution of the device;
 * painting a frame with its annotations takes a few milliseconds of the event dispatch thread. So lightweight
 * components stay above the view on every platform, and a slow driver slows nothing but the view.
 */
public final class SceneViewport extends JPanel implements Session.Listener {
    private final transient Session session;
    private final transient AppearanceModel appearance;
    private final transient RenderLoop renderLoop;
    private final transient FrameRateCounter frameRate = new FrameRateCounter();
    private final transient ViewportPainter painter = new ViewportPainter(this);
    private transient Camera camera = Camera.of(AnatomicalView.ANTERIOR, new double[6]);
    private transient Camera homeCamera = camera;
    private transient LiveScene scene;
    private transient RenderedFrame frame;
    private transient Consumer<String> pickListener = text -> {};
    private transient Runnable cameraListener = () -> {};
    private transient Optional<MouseTool> tool = Optional.empty();
    private String placeholder = "Building the thorax";
    /** Why nothing can be drawn; empty while something can. */
    private String unavailable = "";

    private transient Optional<PickResult> picked = Optional.empty();
    private transient Optional<String> graphicsInfo = Optional.empty();
    private long frameCount;

    public SceneViewport(Session session, AppearanceModel appearance) {
        this.session = session;
        this.appearance = appearance;
        setName("view");
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName("Three-dimensional view of the thorax");
        setToolTipText(null);
        setMinimumSize(new Dimension(200, 150));
        new CameraController(this);
        renderLoop = new RenderLoop(session.live(), session::firstBody, new RenderListener());
        appearance.addListener(this::requestFrame);
        session.addListener(this);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                requestFrame();
            }
        });
        // A screen of another scale.
        addPropertyChangeListener("graphicsConfiguration", e -> requestFrame());
        renderLoop.start();
    }

    @Override
    public void onBody(LiveScene atRest) {
        onScene(atRest);
    }

    @Override
    public void onScene(LiveScene now) {
        boolean otherBody = scene == null || !ViewedBody.of(scene).isAlso(ViewedBody.of(now));
        scene = now;
        picked = Optional.empty();
        pickListener.accept("");
        appearance.setSurfaces(now.surfaces());
        if (otherBody) {
            resetCamera();
        } else {
            requestFrame();
        }
    }

    @Override
    public void onScrub() {
        requestFrame();
    }

    public Camera camera() {
        return camera;
    }

    public void setCamera(Camera other) {
        camera = other;
        requestFrame();
        cameraListener.run();
    }

    /** Sets what runs whenever the camera is another one. */
    public void setCameraListener(Runnable listener) {
        cameraListener = listener;
    }

    /** Goes back to the initial camera; the kind of projection stays. */
    public void resetCamera() {
        if (scene != null) {
            double aspect = getHeight() > 0 ? (double) getWidth() / getHeight() : 1;
            homeCamera = Camera.of(AnatomicalView.ANTERIOR, Surface.bounds(scene.surfaces()), aspect);
        }
        setCamera(homeCamera.withProjection(camera.orthographic()));
    }

    /** Sets what gets the name and the place of a picked structure. */
    public void setPickListener(Consumer<String> listener) {
        pickListener = listener;
    }

    private RenderLoop.Request request() {
        double scale = scale();
        return new RenderLoop.Request(
                scene,
                camera,
                appearance.style(),
                appearance.reference(),
                appearance.accessColours(),
                (int) Math.round(getWidth() * scale),
                (int) Math.round(getHeight() * scale),
                session.historyFrame().orElse(-1));
    }

    private double scale() {
        return getGraphicsConfiguration() == null
                ? 1
                : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    private void requestFrame() {
        if (scene != null && getWidth() > 0 && getHeight() > 0) {
            renderLoop.request(request());
        }
    }

    /** Clicks and wheel turns that are not for the camera. */
    public interface MouseTool {
        boolean isPicking();

        /** Opacity of surfaces for a pick that begins; 0 lets the ray through. */
        ToDoubleFunction<Surface> pickOpacity();

        /** Takes the result of a pick that begins; empty if the ray hits nothing. */
        Consumer<Optional<PickResult>> receiver();

        /** Takes a turn of the wheel; false if it is for the camera. */
        boolean wheelTurned(MouseWheelEvent e);

        /** Takes hold of what is under the mouse; false if dragging is for the camera. */
        boolean pressed(MouseEvent e);

        /** Drags what was taken hold of. */
        void dragged(MouseEvent e);
    }

    public void setTool(Optional<MouseTool> with) {
        tool = with;
    }

    Optional<MouseTool> tool() {
        return tool;
    }

    public void setMarkSource(Supplier<Optional<NeedleMarkers>> marks) {
        renderLoop.setMarkSource(marks);
    }

    /** Runs a task on the render thread; where that has ended, {@code otherwise}. */
    public void runTask(Consumer<OffscreenContext> what, Runnable otherwise) {
        renderLoop.runTask(what, otherwise);
    }

    /** A click: for the tool if it is picking, else it names the structure. */
    void click(int x, int y, boolean twice) {
        if (tool.isPresent() && tool.get().isPicking() && scene != null) {
            pick(x, y, tool.get().pickOpacity(), tool.get().receiver());
        } else {
            pick(x, y, twice);
        }
    }

    /** Finds what is under a pixel; {@code done} gets it on the event dispatch thread. */
    public void pick(int x, int y, ToDoubleFunction<Surface> opacity, Consumer<Optional<PickResult>> done) {
        Consumer<Optional<PickResult>> later = found -> SwingUtilities.invokeLater(() -> done.accept(found));
        renderLoop.pick(x * scale(), y * scale(), request(), opacity, later);
    }

    /** Names the structure under a pixel; {@code turnAbout} makes it the centre of rotation. */
    public void pick(int x, int y, boolean turnAbout) {
        if (scene == null) {
            return;
        }
        SceneStyle seen = appearance.style();
        pick(x, y, surface -> AppearanceModel.opacity(seen, surface), found -> {
            picked = found;
            pickListener.accept(
                    found.map(p -> p.displayName() + "   " + p.positionText()).orElse(""));
            String name = found.map(p -> p.surface().name()).orElse("");
            appearance.changeStyle(style -> style.withHighlighted(name));
            if (turnAbout) {
                found.ifPresent(p -> setCamera(camera.withTarget(p.x(), p.y(), p.z())));
            }
        });
    }

    /** Draws what the view shows, enlarged; {@code done} gets it on the render thread, unless it cannot be drawn. */
    public void snapshot(int enlargement, Consumer<BufferedImage> done) {
        Camera now = camera;
        Annotations annotations = annotationsFor("");
        int width = enlargement * getWidth();
        int height = enlargement * getHeight();
        renderLoop.snapshot(now, appearance.style(), width, height, (image, time, needle) -> {
            needle.ifPresent(marks -> ViewportPainter.outlines(image, marks, now, enlargement));
            annotations.withTimestamp(time).draw(image, now);
            done.accept(image);
        });
    }

    private Annotations annotationsFor(String moment) {
        Annotations plain = Annotations.of(appearance.style()).withTimestamp(moment);
        return scene == null
                ? plain
                : plain.withNotInScan(scene.body().notInScanSummary()).withTitle(BodyName.of(scene.scenario()));
    }

    /** Frames per second; 0 while nothing moves. */
    public double framesPerS() {
        return frameRate.perSecond(System.nanoTime());
    }

    public long frameCount() {
        return frameCount;
    }

    /** Whether nothing can be drawn on this machine. */
    public boolean isUnavailable() {
        return !unavailable.isEmpty();
    }

    /** One sentence on why nothing can be drawn on this machine; empty while something can. */
    public String unavailableReason() {
        return unavailable;
    }

    /** Simulation step of the frame shown; -1 before the first frame. */
    public long shownStep() {
        return frame == null ? -1 : frame.step();
    }

    /** Sets the text that is shown before the first frame. */
    public void setPlaceholder(String text) {
        if (!isUnavailable()) {
            placeholder = text;
            if (frame == null) {
                repaint();
            }
        }
    }

    /** What is written where there is no picture. */
    public String placeholder() {
        return placeholder;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        if (frame == null) {
            painter.paintPlaceholder(g, placeholder);
        } else {
            painter.paint(g, frame, annotationsFor(frame.timeText()));
        }
        g.dispose();
    }

    public Optional<PickResult> picked() {
        return picked;
    }

    /** The renderer; empty until it is known. */
    public Optional<String> graphicsInfo() {
        return graphicsInfo;
    }

    public void close() {
        renderLoop.close();
    }

    public Optional<RenderedFrame> frame() {
        return Optional.ofNullable(frame);
    }

    private final class RenderListener implements RenderLoop.Listener {
        @Override
        public void onReady(GraphicsInfo info) {
            SwingUtilities.invokeLater(
                    () -> graphicsInfo = Optional.of(info.renderer() + ", OpenGL " + info.version()));
        }

        @Override
        public void onFrame(RenderedFrame drawn) {
            SwingUtilities.invokeLater(() -> {
                if (frame != null) {
                    renderLoop.release(frame);
                }
                frame = drawn;
                session.endPictureWait();
                frameCount++;
                frameRate.count(System.nanoTime());
                repaint();
            });
        }

        @Override
        public void onUnavailable(String sentence) {
            SwingUtilities.invokeLater(() -> {
                frame = null;
                placeholder = sentence;
                unavailable = sentence;
                session.endPictureWait();
                repaint();
            });
        }
    }
}
