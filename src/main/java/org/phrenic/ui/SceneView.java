package org.phrenic.ui;

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
import org.phrenic.scene.Annotations;
import org.phrenic.scene.Background;
import org.phrenic.scene.Camera;
import org.phrenic.scene.ColourField;
import org.phrenic.scene.GraphicsInfo;
import org.phrenic.scene.OffscreenGl;
import org.phrenic.scene.Pick;
import org.phrenic.scene.SceneBounds;
import org.phrenic.scene.SceneStyle;
import org.phrenic.scene.View;
import org.phrenic.simulation.Surface;
import org.phrenic.simulation.live.LiveScene;

/**
 * The thorax, as it breathes. The picture itself comes from a {@link RenderLoop}, drawn into a framebuffer on another thread at the pixels of the device; here it is put on the screen with its annotations
 * over it, which takes a few milliseconds of the event dispatch thread. So menus and cards stay above the view on every platform, and a slow driver slows nothing but the view.
 */
final class SceneView extends JPanel {
    private final transient Session session;
    private final transient Looks looks;
    private final transient RenderLoop loop;
    private final transient FrameRate rate = new FrameRate();
    private final transient AnnotationLayer annotations = new AnnotationLayer();
    private transient Camera camera = Camera.of(View.ANTERIOR, new double[6]);
    private transient Camera home = camera;
    private transient LiveScene scene;
    private transient Picture picture;
    private transient Consumer<String> pointed = text -> {};
    private transient Optional<Tool> tool = Optional.empty();
    private String placeholder = "Building the thorax";
    private boolean impossible;
    private transient Optional<Pick> picked = Optional.empty();
    private transient Optional<String> graphics = Optional.empty();
    private long pictures;

    SceneView(Session session, Looks looks) {
        this.session = session;
        this.looks = looks;
        setName("view");
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName("Three-dimensional view of the thorax");
        setToolTipText(null);
        setMinimumSize(new Dimension(200, 150));
        new CameraMouse(this);
        loop = new RenderLoop(session.live(), new FromLoop());
        looks.onChange(this::ask);
        session.listen(new Session.Events() {
            @Override
            public void onScene(LiveScene now) {
                enter(now);
            }

            @Override
            public void onScrub() {
                ask();
            }
        });
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                ask();
            }
        });
        loop.start();
    }

    private void enter(LiveScene now) {
        boolean first = scene == null;
        boolean otherBody =
                first || !scene.scenario().anatomy().equals(now.scenario().anatomy());
        scene = now;
        looks.scene(now.surfaces());
        if (otherBody) {
            double aspect = getHeight() > 0 ? (double) getWidth() / getHeight() : 1;
            home = Camera.of(View.ANTERIOR, SceneBounds.of(now.surfaces()), aspect);
            camera = home.withProjection(camera.orthographic());
        }
        ask();
    }

    Camera camera() {
        return camera;
    }

    void setCamera(Camera other) {
        camera = other;
        ask();
    }

    /** The camera as at first. */
    void resetCamera() {
        if (scene != null && getHeight() > 0) {
            home = Camera.of(View.ANTERIOR, SceneBounds.of(scene.surfaces()), (double) getWidth() / getHeight());
        }
        setCamera(home);
    }

    /** Told what is pointed at, in one line. */
    void onPointed(Consumer<String> listener) {
        pointed = listener;
    }

    private Wanted wanted() {
        double scale = scale();
        return new Wanted(
                scene,
                camera,
                looks.style(),
                looks.reference(),
                looks.access(),
                (int) Math.round(getWidth() * scale),
                (int) Math.round(getHeight() * scale),
                session.scrubbed().orElse(-1));
    }

    private double scale() {
        return getGraphicsConfiguration() == null
                ? 1
                : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    private void ask() {
        if (scene != null && getWidth() > 0 && getHeight() > 0) {
            loop.show(wanted());
        }
    }

    /** What the mouse does besides turning, moving and naming. */
    interface Tool {
        /** Whether the next click is for this. */
        boolean isAwaiting();

        /** How well a surface catches a click that is awaited; 0 for not at all. */
        double catches(Surface surface);

        /** What was clicked on; empty for nothing of what is sought. */
        void clicked(Optional<Pick> found);

        /** The wheel was turned; says whether that was for this. */
        boolean turned(MouseWheelEvent e);
    }

    void setTool(Optional<Tool> with) {
        tool = with;
    }

    Optional<Tool> tool() {
        return tool;
    }

    /** Shows needle and target from now on. */
    void mark(RenderLoop.Marks marks) {
        loop.mark(marks);
    }

    /** Does something with what draws, on the drawing thread. */
    void work(Consumer<OffscreenGl> what) {
        loop.work(what);
    }

    /** A click: for the tool if that awaits one, else it names. */
    void click(int x, int y, boolean twice) {
        if (tool.isPresent() && tool.get().isAwaiting() && scene != null) {
            Tool awaiting = tool.get();
            double scale = scale();
            loop.pick(
                    x * scale,
                    y * scale,
                    wanted(),
                    awaiting::catches,
                    found -> SwingUtilities.invokeLater(() -> awaiting.clicked(found)));
        } else {
            pick(x, y, twice);
        }
    }

    /** Says what lies under a pixel; turns about it from now on if {@code turnAbout}. */
    void pick(int x, int y, boolean turnAbout) {
        if (scene == null) {
            return;
        }
        double scale = scale();
        SceneStyle seen = looks.style();
        loop.pick(
                x * scale,
                y * scale,
                wanted(),
                surface -> Looks.opacity(seen, surface),
                found -> SwingUtilities.invokeLater(() -> {
                    picked = found;
                    pointed.accept(found.map(pick -> pick.name() + "   " + pick.place())
                            .orElse(""));
                    looks.change(style -> style.withHighlighted(
                            found.map(Pick::surface).map(Surface::name).orElse("")));
                    if (turnAbout) {
                        found.ifPresent(pick -> setCamera(camera.withTarget(pick.x(), pick.y(), pick.z())));
                    }
                }));
    }

    /** Makes a picture to be kept, with its annotations; {@code done} is told on the drawing thread. */
    void still(int width, int height, Consumer<BufferedImage> done) {
        Camera now = camera;
        Annotations marks = marks("");
        loop.still(now, looks.style(), width, height, image -> {
            marks.draw(image, now);
            done.accept(image);
        });
    }

    private Annotations marks(String moment) {
        SceneStyle style = looks.style();
        Annotations plain =
                Annotations.on(style.background() == Background.LIGHT).withMoment(moment);
        return style.field() == ColourField.NONE
                ? plain
                : plain.withScale(style.field().label(), style.scale());
    }

    /** Pictures a second; 0 while nothing moves. */
    double picturesPerS() {
        return rate.perSecond(System.nanoTime());
    }

    /** Pictures put on the screen so far. */
    long pictures() {
        return pictures;
    }

    /** Whether this machine can make no picture. */
    boolean isImpossible() {
        return impossible;
    }

    /** Step of the simulation that is on the screen; -1 before the first picture. */
    long shownStep() {
        return picture == null ? -1 : picture.step();
    }

    /** Says what is being waited for. */
    void setPlaceholder(String text) {
        if (!impossible) {
            placeholder = text;
            if (picture == null) {
                repaint();
            }
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        if (picture == null) {
            paintPlaceholder(g);
        } else {
            paintPicture(g, picture);
        }
        g.dispose();
    }

    private void paintPicture(Graphics2D g, Picture now) {
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
            now.marks().ifPresent(marks -> marks.outline(g, now.wanted().camera(), getWidth(), getHeight()));
        }
        annotations.draw(g, this, marks(now.moment()), now.wanted().camera());
    }

    private void paintPlaceholder(Graphics2D g) {
        g.setColor(Theme.viewBackground());
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(Theme.quietText());
        g.setFont(getFont() == null ? g.getFont() : getFont());
        int y = getHeight() / 2;
        for (String line : Lines.wrap(placeholder, g.getFontMetrics(), Math.max(80, getWidth() - 80))) {
            g.drawString(line, (getWidth() - g.getFontMetrics().stringWidth(line)) / 2, y);
            y += g.getFontMetrics().getHeight();
        }
    }

    /** What was clicked last. */
    Optional<Pick> picked() {
        return picked;
    }

    /** What draws; empty until it is known. */
    Optional<String> graphics() {
        return graphics;
    }

    /** Ends the drawing. */
    void close() {
        loop.close();
    }

    Optional<Picture> picture() {
        return Optional.ofNullable(picture);
    }

    /** Takes pictures over to the event dispatch thread. */
    private final class FromLoop implements RenderLoop.Viewer {
        @Override
        public void ready(GraphicsInfo info) {
            SwingUtilities.invokeLater(() -> graphics = Optional.of(info.renderer() + ", OpenGL " + info.version()));
        }

        @Override
        public void drawn(Picture drawn) {
            SwingUtilities.invokeLater(() -> {
                if (picture != null) {
                    loop.giveBack(picture);
                }
                picture = drawn;
                pictures++;
                rate.count(System.nanoTime());
                repaint();
            });
        }

        @Override
        public void impossible(String sentence) {
            SwingUtilities.invokeLater(() -> {
                picture = null;
                placeholder = sentence;
                impossible = true;
                repaint();
            });
        }
    }
}
