package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.nio.IntBuffer;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.Tile;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Draws a scene with OpenGL 3.3 core into its own framebuffer, for a window or for picture files. The passes are
 * background, opaque surfaces, depth edges, lines and translucent surfaces. Not thread-safe; the OpenGL context must be
 * current on the calling thread. After {@link #dispose} the renderer can be used in another context. Framebuffer,
 * viewport and vertex array are restored after drawing.
 */
public final class Renderer {
    /** Listener called after a pass has been submitted to the driver. */
    interface PassListener {
        void done(GL3 gl, String pass);
    }

    private static final double NANOS_PER_MS = 1e6;
    private static final int ALPHA_MASK = 0xff000000;

    private final List<Surface> surfaces;
    private final List<Overlay> overlays;
    private final Map<String, BoundingBox> boundingBoxes = new HashMap<>();
    private final Map<String, float[]> poses = new HashMap<>();
    private final Map<String, float[]> fieldValues = new HashMap<>();
    private int fieldVersion;
    private final GlResources resources = new GlResources();
    private FrameStatistics statistics = new FrameStatistics(0, 0, 0, 0);
    private PassListener listener = (gl, pass) -> {};

    private GraphicsInfo info;
    private GpuScene scene;
    private SurfacePass faces;
    private LinePass lines;
    private ScreenPass screen;
    private OpaquePass opaque;
    private TranslucentPass translucent;
    private RenderTargets targets;
    private IntBuffer pixels = IntBuffer.allocate(0);

    public Renderer(List<Surface> surfaces, List<Overlay> overlays) {
        this.surfaces = List.copyOf(surfaces);
        this.overlays = List.copyOf(overlays);
        surfaces.forEach(s -> boundingBoxes.put(s.name(), BoundingBox.of(s.rest())));
    }

    /** Draws a frame into the framebuffer of this renderer. */
    public void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, int width, int height) {
        draw(gl, frame, camera, style, Tile.whole(width, height));
    }

    /** Draws a tile of a picture. */
    void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, Tile tile) {
        long begun = System.nanoTime();
        GlState state = GlState.of(gl);
        resources.resetStatistics();
        try {
            drawPasses(gl, frame, camera, style, tile);
        } finally {
            state.restore(gl);
        }
        statistics = resources.statistics((System.nanoTime() - begun) / NANOS_PER_MS);
    }

    private void drawPasses(GL3 gl, Frame frame, Camera camera, SceneStyle style, Tile tile) {
        if (scene == null) {
            createPasses(gl);
        }
        boolean peeled = style.quality().transparency() == Transparency.PEELED;
        int samples = peeled ? 0 : Math.min(style.quality().samples(), info.maxSamples());
        double scale = scale(style.quality(), peeled, samples);
        resize(gl, tile, scale, samples < 2 ? 0 : samples);
        scene.update(gl, frame, style, fieldValues, fieldVersion);
        scene.setPoses(poses);
        faces.setCoarse(scale < 1 && scene.hasCoarse(gl));
        listener.done(gl, "upload");
        ViewTransform transform = ViewTransform.of(camera, tile, scale);
        gl.glDepthMask(true);
        gl.glDisable(GL3.GL_BLEND);
        gl.glPolygonMode(GL3.GL_FRONT_AND_BACK, GL3.GL_FILL);
        drawOpaque(gl, transform, style);
        drawLines(gl, transform, style);
        setClipping(gl, style.clip().isPresent());
        drawTranslucent(gl, transform, style);
        setClipping(gl, false);
        targets.resolve(gl, screen);
        listener.done(gl, "finish");
    }

    private static double scale(SceneStyle.Quality quality, boolean peeled, int samples) {
        if (peeled && quality.samples() > 1) {
            return 2;
        }
        return samples < 2 ? quality.resolution() : 1;
    }

    /** Creates what draws, or nothing: a shader that a driver refuses is the reason of each picture that fails. */
    private void createPasses(GL3 gl) {
        info = GraphicsInfo.of(gl);
        try {
            GpuScene whole = new GpuScene(gl, resources, surfaces, overlays);
            faces = new SurfacePass(resources);
            lines = new LinePass(resources);
            screen = new ScreenPass(gl, resources);
            opaque = new OpaquePass(faces, screen, new CapPass(gl, resources));
            translucent = new TranslucentPass(faces, screen);
            scene = whole;
        } catch (RuntimeException | Error e) {
            resources.deleteAll(gl);
            throw e;
        }
    }

    private void resize(GL3 gl, Tile tile, double scale, int samples) {
        if (targets == null || !targets.matches(tile.width(), tile.height(), scale, samples)) {
            if (targets != null) {
                targets.dispose(gl);
                targets = null;
            }
            targets = new RenderTargets(gl, tile.width(), tile.height(), scale, samples);
        }
    }

    static void setClipping(GL3 gl, boolean on) {
        if (on) {
            gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        } else {
            gl.glDisable(GL3.GL_CLIP_DISTANCE0);
        }
    }

    private List<SurfaceBuffers> visible(SceneStyle style, Predicate<Appearance> condition) {
        Predicate<Appearance> shown = condition.and(Appearance::visible);
        return scene.surfaces().stream()
                .filter(s -> style.appearance(s.surface().name()).filter(shown).isPresent())
                .toList();
    }

    private BoundingBox box(SurfaceBuffers surface) {
        return boundingBoxes.get(surface.surface().name());
    }

    private void drawOpaque(GL3 gl, ViewTransform transform, SceneStyle style) {
        // Front to back, so that hidden fragments fail the depth test early.
        List<SurfaceBuffers> shown = visible(style, a -> !a.wireframe() && !a.isTranslucent()).stream()
                .sorted(Comparator.comparing(s -> box(s).nearestDepth(transform)))
                .toList();
        opaque.draw(gl, targets, shown, transform, style);
        listener.done(gl, "opaque");
        int depth = targets.depthTexture(gl);
        targets.bindColourOnly(gl);
        int[] part = BoundingBox.screenRectangle(shown.stream().map(this::box).toList(), transform);
        gl.glEnable(GL3.GL_SCISSOR_TEST);
        gl.glScissor(part[0], part[1], part[2], part[3]);
        screen.darkenDepthEdges(gl, depth, transform);
        gl.glDisable(GL3.GL_SCISSOR_TEST);
        targets.drawTarget().bind(gl);
        listener.done(gl, "edges");
    }

    private void drawLines(GL3 gl, ViewTransform transform, SceneStyle style) {
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glDepthMask(false);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_SRC_ALPHA, GL3.GL_ONE_MINUS_SRC_ALPHA);
        setClipping(gl, true);
        gl.glEnable(GL3.GL_PROGRAM_POINT_SIZE);
        visible(style, Appearance::wireframe).forEach(s -> lines.drawEdges(gl, s, transform, style));
        if (style.lines().restWireframe()) {
            visible(style, a -> true).stream()
                    .filter(s -> hasRestWireframe(s.surface(), style))
                    .forEach(s -> lines.drawRestEdges(gl, s, transform, style));
        }
        lines.drawOverlays(gl, scene.overlays(), transform, style);
        gl.glDisable(GL3.GL_PROGRAM_POINT_SIZE);
        gl.glDisable(GL3.GL_BLEND);
        gl.glDepthMask(true);
        listener.done(gl, "lines");
    }

    private static boolean hasRestWireframe(Surface surface, SceneStyle style) {
        return surface.motion() != Surface.Motion.STILL
                && (surface.kind() == StructureKind.DIAPHRAGM || style.showsField(surface.name()));
    }

    private void drawTranslucent(GL3 gl, ViewTransform transform, SceneStyle style) {
        List<SurfaceBuffers> shown =
                visible(style, a -> !a.wireframe() && a.isTranslucent() && a.opacity() > 0).stream()
                        .sorted(Comparator.comparing(s -> box(s).longestSide()))
                        .toList();
        if (shown.isEmpty()) {
            return;
        }
        if (style.quality().transparency() == Transparency.PEELED) {
            translucent.drawPeeled(gl, targets, shown, transform, style);
        } else {
            translucent.drawTwoPass(gl, targets, shown, transform, style);
        }
        listener.done(gl, "translucent");
    }

    public BufferedImage readPixels(GL3 gl) {
        Framebuffer shown = targets.resolved();
        BufferedImage image = new BufferedImage(shown.width(), shown.height(), BufferedImage.TYPE_INT_RGB);
        readPixels(gl, image);
        return image;
    }

    /**
     * Copies the picture, top row first, into an image of the same size and of type {@link BufferedImage#TYPE_INT_RGB}.
     *
     * @throws IllegalArgumentException if the size or the type of the image differs
     */
    public void readPixels(GL3 gl, BufferedImage into) {
        int width = targets.resolved().width();
        int height = targets.resolved().height();
        if (into.getWidth() != width || into.getHeight() != height || into.getType() != BufferedImage.TYPE_INT_RGB) {
            throw new IllegalArgumentException("found an image of " + into.getWidth() + " by " + into.getHeight()
                    + ", expected RGB of " + width + " by " + height);
        }
        if (pixels.capacity() != width * height) {
            pixels = Buffers.newDirectIntBuffer(width * height);
        }
        GlState state = GlState.of(gl);
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, targets.resolved().name());
        gl.glPixelStorei(GL3.GL_PACK_ALIGNMENT, 4);
        gl.glReadPixels(0, 0, width, height, GL3.GL_BGRA, GL3.GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
        state.restore(gl);
        int[] rgb = ((DataBufferInt) into.getRaster().getDataBuffer()).getData();
        for (int y = 0; y < height; y++) {
            pixels.get((height - 1 - y) * width, rgb, y * width, width);
        }
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] &= ~ALPHA_MASK;
        }
    }

    /**
     * Sets the values shown for {@link ColourField#DISTANCE} or {@link ColourField#ACCESS} on a structure.
     *
     * @throws IllegalArgumentException if there is no such structure or the number of values is not its number of
     *     vertices
     */
    public void setField(String structure, float[] valuePerVertex) {
        int expected = surface(structure).rest().vertexCount();
        if (valuePerVertex.length != expected) {
            throw new IllegalArgumentException(
                    structure + ": found " + valuePerVertex.length + " values, expected one a vertex, " + expected);
        }
        fieldValues.put(structure, valuePerVertex.clone());
        fieldVersion++;
    }

    /**
     * Sets the pose of a static surface; takes effect in the next picture.
     *
     * @param pose affine transform x' = M x + t as a row-major 3 x 4 matrix [M t]; t in mm
     * @throws IllegalArgumentException if there is no such structure
     */
    public void setPose(String structure, float[] pose) {
        Surface surface = surface(structure);
        poses.put(structure, pose.clone());
        double[] moved = new double[surface.rest().positions().length];
        Frame.transform(pose, surface.rest().positions(), moved);
        boundingBoxes.put(structure, BoundingBox.of(surface.rest().withPositions(moved)));
    }

    private Surface surface(String structure) {
        return surfaces.stream()
                .filter(s -> s.name().equals(structure))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("found no structure '" + structure + "' in the scene"));
    }

    /** Deletes all OpenGL objects. */
    public void dispose(GL3 gl) {
        resources.deleteAll(gl);
        scene = null;
        if (targets != null) {
            targets.dispose(gl);
            targets = null;
        }
    }

    public int liveObjects() {
        return resources.liveCount() + (targets == null ? 0 : targets.liveCount());
    }

    /** Waits until the triangles of coarser pictures have been computed, if one has been drawn. */
    void awaitCoarse() {
        scene.awaitCoarse();
    }

    void setPassListener(PassListener told) {
        listener = told;
    }

    public FrameStatistics statistics() {
        return statistics;
    }

    public List<Surface> surfaces() {
        return surfaces;
    }
}
