package org.phrenic.ui.view;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Theme;

/**
 * The thorax, as it breathes. The picture itself comes from a {@link RenderLoop}, drawn into a framebuffer on another
 * thread at the pixels of the device; here it is put on the screen with its annotations over it, which takes a few
 * milliseconds of the event dispatch thread. So menus and cards stay above the view on every platform, and a slow
 * driver slows nothing but the view.
 */
public final class SceneViewport extends JPanel {
    private final transient Session session;
    private final transient AppearanceModel appearance;
    private final transient RenderLoop renderLoop;
    private final transient FrameRateCounter frameRate = new FrameRateCounter();
    private final transient AnnotationLayer annotations = new AnnotationLayer();
    private transient Camera camera = Camera.of(AnatomicalView.ANTERIOR, new double[6]);
    private transient Camera homeCamera = camera;
    private transient LiveScene scene;
    private transient RenderedFrame frame;
    private transient Consumer<String> pickListener = text -> {};
    private transient Optional<MouseTool> tool = Optional.empty();
    private String placeholder = "Building the thorax";
    private boolean unavailable;
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
        renderLoop = new RenderLoop(session.live(), new RenderListener());
        appearance.addListener(this::requestFrame);
        session.addListener(new Session.Listener() {
            @Override
            public void onScene(LiveScene now) {
                setScene(now);
            }

            @Override
            public void onScrub() {
                requestFrame();
            }
        });
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                requestFrame();
            }
        });
        renderLoop.start();
    }

    private void setScene(LiveScene now) {
        boolean first = scene == null;
        boolean otherBody =
                first || !scene.scenario().anatomy().equals(now.scenario().anatomy());
        scene = now;
        appearance.setSurfaces(now.surfaces());
        if (otherBody) {
            double aspect = getHeight() > 0 ? (double) getWidth() / getHeight() : 1;
            homeCamera = Camera.of(AnatomicalView.ANTERIOR, SceneBounds.of(now.surfaces()), aspect);
            camera = homeCamera.withProjection(camera.orthographic());
        }
        requestFrame();
    }

    public Camera camera() {
        return camera;
    }

    public void setCamera(Camera other) {
        camera = other;
        requestFrame();
    }

    /** The camera as at first. */
    public void resetCamera() {
        if (scene != null && getHeight() > 0) {
            homeCamera = Camera.of(
                    AnatomicalView.ANTERIOR, SceneBounds.of(scene.surfaces()), (double) getWidth() / getHeight());
        }
        setCamera(homeCamera);
    }

    /** Told what is pointed at, in one line. */
    public void setPickListener(Consumer<String> listener) {
        pickListener = listener;
    }

    private RenderRequest request() {
        double scale = scale();
        return new RenderRequest(
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

    /** What the mouse does besides turning, moving and naming. */
    public interface MouseTool {
        /** Whether the next click is for this. */
        boolean isPicking();

        /** How well a surface catches a click that is awaited; 0 for not at all. */
        double pickOpacity(Surface surface);

        /** What was clicked on; empty for nothing of what is sought. */
        void picked(Optional<PickResult> found);

        /** The wheel was turned; says whether that was for this. */
        boolean wheelTurned(MouseWheelEvent e);
    }

    public void setTool(Optional<MouseTool> with) {
        tool = with;
    }

    Optional<MouseTool> tool() {
        return tool;
    }

    /** Shows needle and target from now on. */
    public void setMarkSource(RenderLoop.MarkSource marks) {
        renderLoop.setMarkSource(marks);
    }

    /** Does something with what draws, on the drawing thread. */
    public void runTask(Consumer<OffscreenContext> what) {
        renderLoop.runTask(what);
    }

    /** A click: for the tool if that awaits one, else it names. */
    void click(int x, int y, boolean twice) {
        if (tool.isPresent() && tool.get().isPicking() && scene != null) {
            MouseTool awaiting = tool.get();
            double scale = scale();
            renderLoop.pick(
                    x * scale,
                    y * scale,
                    request(),
                    awaiting::pickOpacity,
                    found -> SwingUtilities.invokeLater(() -> awaiting.picked(found)));
        } else {
            pick(x, y, twice);
        }
    }

    /** Says what lies under a pixel; turns about it from now on if {@code turnAbout}. */
    public void pick(int x, int y, boolean turnAbout) {
        if (scene == null) {
            return;
        }
        double scale = scale();
        SceneStyle seen = appearance.style();
        renderLoop.pick(
                x * scale,
                y * scale,
                request(),
                surface -> AppearanceModel.opacity(seen, surface),
                found -> SwingUtilities.invokeLater(() -> {
                    picked = found;
                    pickListener.accept(found.map(pick -> pick.displayName() + "   " + pick.positionText())
                            .orElse(""));
                    appearance.changeStyle(style -> style.withHighlighted(
                            found.map(PickResult::surface).map(Surface::name).orElse("")));
                    if (turnAbout) {
                        found.ifPresent(pick -> setCamera(camera.withTarget(pick.x(), pick.y(), pick.z())));
                    }
                }));
    }

    /** Makes a picture to be kept, with its annotations; {@code done} is told on the drawing thread. */
    public void snapshot(int width, int height, Consumer<BufferedImage> done) {
        Camera now = camera;
        Annotations marks = annotationsFor("");
        renderLoop.snapshot(now, appearance.style(), width, height, image -> {
            marks.draw(image, now);
            done.accept(image);
        });
    }

    private Annotations annotationsFor(String moment) {
        SceneStyle style = appearance.style();
        Annotations plain = Annotations.forBackground(style.background() == SceneBackground.LIGHT)
                .withTimestamp(moment);
        return style.field() == ColourField.NONE
                ? plain
                : plain.withScale(style.field().label(), style.scale());
    }

    /** Pictures a second; 0 while nothing moves. */
    public double framesPerS() {
        return frameRate.perSecond(System.nanoTime());
    }

    /** Pictures put on the screen so far. */
    public long frameCount() {
        return frameCount;
    }

    /** Whether this machine can make no picture. */
    public boolean isUnavailable() {
        return unavailable;
    }

    /** Step of the simulation that is on the screen; -1 before the first picture. */
    public long shownStep() {
        return frame == null ? -1 : frame.step();
    }

    /** Says what is being waited for. */
    public void setPlaceholder(String text) {
        if (!unavailable) {
            placeholder = text;
            if (frame == null) {
                repaint();
            }
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        if (frame == null) {
            paintPlaceholder(g);
        } else {
            paintPicture(g, frame);
        }
        g.dispose();
    }

    private void paintPicture(Graphics2D g, RenderedFrame now) {
        BufferedImage image = now.image();
        AffineTransform device = g.getTransform();
        boolean same = image.getWidth() == Math.round(getWidth() * device.getScaleX())
                && image.getHeight() == Math.round(getHeight() * device.getScaleY());
        if (same) {
            g.drawImage(image, AffineTransform.getScaleInstance(1 / device.getScaleX(), 1 / device.getScaleY()), null);
        } else {
            // Until a picture of the new size is there: the old one in the middle, not distorted.
            double fit = (double) getHeight() / image.getHeight();
            g.setColor(new Color(image.getRGB(0, 0)));
            g.fillRect(0, 0, getWidth(), getHeight());
            AffineTransform place = AffineTransform.getTranslateInstance((getWidth() - fit * image.getWidth()) / 2, 0);
            place.scale(fit, fit);
            g.drawImage(image, place, null);
        }
        if (same) {
            now.needleMarks()
                    .ifPresent(marks -> marks.drawOutlines(g, now.request().camera(), getWidth(), getHeight()));
        }
        annotations.draw(g, this, annotationsFor(now.timeText()), now.request().camera());
    }

    private void paintPlaceholder(Graphics2D g) {
        g.setColor(Theme.VIEW_BACKGROUND);
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Theme.SECONDARY_TEXT);
        g.setFont(getFont() == null ? g.getFont() : getFont());
        int y = getHeight() / 2;
        for (String line : LineBreaker.wrap(placeholder, g.getFontMetrics(), Math.max(80, getWidth() - 80))) {
            g.drawString(line, (getWidth() - g.getFontMetrics().stringWidth(line)) / 2, y);
            y += g.getFontMetrics().getHeight();
        }
    }

    /** What was clicked last. */
    public Optional<PickResult> picked() {
        return picked;
    }

    /** What draws; empty until it is known. */
    public Optional<String> graphicsInfo() {
        return graphicsInfo;
    }

    /** Ends the drawing. */
    public void close() {
        renderLoop.close();
    }

    public Optional<RenderedFrame> frame() {
        return Optional.ofNullable(frame);
    }

    /** Takes pictures over to the event dispatch thread. */
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
                unavailable = true;
                repaint();
            });
        }
    }
}
