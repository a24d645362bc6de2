package org.phrenic.scene.gl;

import com.jogamp.common.util.VersionNumber;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.DebugGL3;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.Tile;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Frame;

/**
 * An OpenGL context without a window. On Linux it uses the X server if one with GLX is reachable, and surfaceless EGL
 * otherwise or if the system property {@code phrenic.opengl} is {@code egl}. On macOS and Windows it uses the window
 * system. Not thread-safe.
 */
public final class OffscreenContext implements AutoCloseable {
    /** Maximum time to start the driver, which usually takes well under a second. */
    private static final long START_TIMEOUT_S = 30;

    private static final long TOOLKIT_TIMEOUT_S = 5;

    /** System property: {@code egl} draws through surfaceless EGL where an X server is reachable too. */
    private static final String WAY_PROPERTY = "phrenic.opengl";

    /** Environment variable that names the X server. */
    private static final String DISPLAY = "DISPLAY";

    /** Maximum side of a tile, pixels. Larger pictures are drawn in tiles to limit memory. */
    static final int MAX_TILE = 3072;

    /** That of the shaders, {@code #version 330 core}. */
    private static final VersionNumber NEEDED = new VersionNumber(3, 3, 0);

    private static final String OLD_DRIVER = "No pictures can be made here: the graphics driver has no OpenGL 3.3";

    private static final String NOT_STARTED = "No pictures can be made here: OpenGL 3.3 could not be started";
    private static final String OTHER_WAY = "; java -Dphrenic.opengl=egl may draw without the display";

    private static final String SHUTDOWN_THREAD = "NativeWindowFactory_ShutdownHook";

    /** The context that {@link #prepare} has begun to open. */
    private static final AtomicReference<FutureTask<OffscreenContext>> PREPARED = new AtomicReference<>();

    private static final CountDownLatch TOOLKIT = new CountDownLatch(1);
    private static final System.Logger LOG = System.getLogger(OffscreenContext.class.getName());

    private final GLOffscreenAutoDrawable drawable;
    private final GLContext context;
    private final GraphicsInfo info;
    private boolean debugging;

    private OffscreenContext(GLOffscreenAutoDrawable drawable) {
        this.drawable = drawable;
        context = drawable.getContext();
        GraphicsInfo[] found = new GraphicsInfo[1];
        run(gl -> found[0] = GraphicsInfo.of(gl));
        info = found[0];
    }

    /**
     * Begins to open the context that the next {@link #open} returns. The OpenGL libraries wait once for the event
     * dispatch thread when they are loaded: call {@link #awaitToolkit} before that thread gets long work to do.
     */
    public static void prepare() {
        FutureTask<OffscreenContext> task = new FutureTask<>(OffscreenContext::start);
        if (PREPARED.compareAndSet(null, task)) {
            begin(task);
        }
    }

    /** Waits until the context that is prepared needs the event dispatch thread no more; not called on that thread. */
    public static void awaitToolkit() throws InterruptedException {
        if (PREPARED.get() != null && !TOOLKIT.await(TOOLKIT_TIMEOUT_S, TimeUnit.SECONDS)) {
            LOG.log(System.Logger.Level.INFO, "The graphics driver starts slowly");
        }
    }

    private static void begin(FutureTask<OffscreenContext> task) {
        Thread thread = new Thread(task, "graphics start");
        thread.setDaemon(true);
        thread.start();
    }

    /** Like {@link #open}, and also sets {@code java.awt.headless}. */
    public static OffscreenContext headless() throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return open();
    }

    /**
     * Opens a context; needs no display where the platform allows that.
     *
     * @throws NoGraphicsException if no context can be opened; the message is one sentence
     */
    public static OffscreenContext open() throws NoGraphicsException {
        FutureTask<OffscreenContext> prepared = PREPARED.getAndSet(null);
        FutureTask<OffscreenContext> task = prepared == null ? new FutureTask<>(OffscreenContext::start) : prepared;
        if (prepared == null) {
            begin(task);
        }
        try {
            return task.get(START_TIMEOUT_S, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            String sentence = "No pictures can be made here: the graphics driver did not answer within ";
            throw new NoGraphicsException(sentence + START_TIMEOUT_S + " s", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new NoGraphicsException("No pictures were made: starting the graphics was interrupted", e);
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            if (cause instanceof NoGraphicsException known) {
                throw known;
            }
            if (cause instanceof UnsatisfiedLinkError missing) {
                silenceShutdown();
                throw NoGraphicsException.missingLibrary(missing);
            }
            throw new NoGraphicsException(advised(NOT_STARTED, System.getenv(DISPLAY)), cause);
        }
    }

    /** JOGL's shutdown hook calls the libraries that could not be loaded. */
    private static void silenceShutdown() {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, problem) -> {
            if (problem instanceof UnsatisfiedLinkError && thread.getName().equals(SHUTDOWN_THREAD)) {
                LOG.log(System.Logger.Level.DEBUG, "JOGL does not shut down", problem);
            } else if (before != null) {
                before.uncaughtException(thread, problem);
            } else {
                LOG.log(System.Logger.Level.ERROR, "Thread " + thread.getName() + " ended", problem);
            }
        });
    }

    /**
     * Whether a context is opened by an X server, in place of the window system of the platform or surfaceless EGL.
     *
     * @param display value of DISPLAY; null for none
     */
    static boolean isOnXServer(String display) {
        boolean isEglWanted = System.getProperty(WAY_PROPERTY, "").equals("egl");
        return !DisplayServer.isNotNeeded() && !isEglWanted && DisplayServer.hasGlx(display);
    }

    /** A sentence on why nothing can be drawn, with the way without the X server where that is asked. */
    static String advised(String sentence, String display) {
        return sentence + (isOnXServer(display) ? OTHER_WAY : "");
    }

    private static NoGraphicsException advised(String sentence) {
        return new NoGraphicsException(advised(sentence, System.getenv(DISPLAY)));
    }

    private static OffscreenContext start() throws NoGraphicsException {
        boolean display = DisplayServer.isNotNeeded() || isOnXServer(System.getenv(DISPLAY));
        try {
            if (display) {
                // Asks the event dispatch thread once.
                NativeWindowFactory.initSingleton();
            }
        } finally {
            TOOLKIT.countDown();
        }
        GLDrawableFactory factory = display ? GLDrawableFactory.getDesktopFactory() : SurfacelessEgl.factory();
        if (factory == null) {
            throw advised("No pictures can be made here: the display offers no OpenGL");
        }
        if (!GLProfile.isAvailable(factory.getDefaultDevice(), GLProfile.GL3)) {
            Optional<String> missing = display ? Optional.empty() : SurfacelessEgl.missingLibrary();
            throw missing.map(library -> NoGraphicsException.missingLibrary(library, null))
                    .orElseGet(() -> advised(OLD_DRIVER));
        }
        GLCapabilities wanted = new GLCapabilities(GLProfile.get(factory.getDefaultDevice(), GLProfile.GL3));
        wanted.setOnscreen(false);
        wanted.setFBO(true);
        GLOffscreenAutoDrawable drawable =
                factory.createOffscreenAutoDrawable(factory.getDefaultDevice(), wanted, null, 64, 64);
        drawable.display();
        if (drawable.getContext() == null || !drawable.getContext().isCreated()) {
            drawable.destroy();
            throw advised(OLD_DRIVER);
        }
        // The profile GL3 begins with version 3.1.
        Optional<String> obstacle = obstacle(drawable.getContext().getGLVersionNumber());
        if (obstacle.isPresent()) {
            drawable.destroy();
            throw advised(obstacle.get());
        }
        return new OffscreenContext(drawable);
    }

    /** Why nothing can be drawn by a driver of a version of OpenGL; empty if it can. */
    static Optional<String> obstacle(VersionNumber version) {
        return version.compareTo(NEEDED) >= 0
                ? Optional.empty()
                : Optional.of(OLD_DRIVER + ", it has " + version.getMajor() + "." + version.getMinor());
    }

    public BufferedImage render(
            Renderer renderer, Frame frame, Camera camera, SceneStyle style, int width, int height) {
        SceneStyle.Quality quality = style.quality();
        int most = Math.min(MAX_TILE, info.maxSize());
        // Depth peeling with antialiasing renders at twice the width and height (2 x 2 supersampling).
        int side = quality.transparency() == Transparency.PEELED && quality.samples() > 1 ? most / 2 : most;
        return render(renderer, frame, camera, style, width, height, side);
    }

    /** Draws a picture in tiles of at most the given side, pixels. */
    BufferedImage render(
            Renderer renderer, Frame frame, Camera camera, SceneStyle style, int width, int height, int side) {
        BufferedImage whole = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        run(gl -> {
            for (Tile tile : Tile.split(width, height, side)) {
                renderer.draw(gl, frame, camera, style, tile);
                tile.paste(renderer.readPixels(gl), whole);
            }
        });
        return whole;
    }

    public void release(Renderer renderer) {
        run(renderer::dispose);
    }

    /**
     * Runs code with the context current on this thread.
     *
     * @throws IllegalStateException if the context is current on another thread
     */
    public void run(Consumer<GL3> drawing) {
        try {
            if (context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
                throw new IllegalStateException("the graphics context is in use elsewhere");
            }
            GL gl = context.getGL();
            drawing.accept(debugging ? new DebugGL3(gl.getGL3()) : gl.getGL3());
        } catch (GLException e) {
            throw new IllegalStateException("drawing failed: " + e.getMessage(), e);
        } finally {
            if (context.isCurrent()) {
                context.release();
            }
        }
    }

    /** Turns every OpenGL error into an exception. */
    void enableDebugging() {
        debugging = true;
    }

    public GraphicsInfo info() {
        return info;
    }

    @Override
    public void close() {
        drawable.destroy();
    }
}
