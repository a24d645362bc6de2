package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.nio.IntBuffer;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
 * Draws a scene with OpenGL 3.3 core into a framebuffer of its own, on a screen or without one: background, what is
 * opaque, darkened edges, lines, what is clear. Used by one thread at a time, with its context current; after
 * {@link #dispose} it may be used in another context. The framebuffer, viewport and vertex array that were bound before
 * are bound again afterwards.
 */
public final class Renderer {
    /** Told when a pass has been handed to the driver. */
    interface PassListener {
        void done(GL3 gl, String pass);
    }

    private static final double NANOS_PER_MS = 1e6;
    private static final int ALPHA_MASK = 0xff000000;

    private final List<Surface> surfaces;
    private final List<Overlay> overlays;
    private final Map<String, BoundingBox> boundingBoxes = new LinkedHashMap<>();
    private final Map<String, float[]> poses = new LinkedHashMap<>();
    private final Map<String, float[]> fieldValues = new LinkedHashMap<>();
    private int fieldVersion;
    private final GlResources objects = new GlResources();
    private FrameStatistics statistics = new FrameStatistics(0, 0, 0, 0);
    private PassListener listener = (gl, pass) -> {};
    private GraphicsInfo info;
    private GpuScene scene;
    private SurfacePass faces;
    private LinePass lines;
    private ScreenPass screen;
    private CapPass caps;
    private TranslucentPass clearPass;
    private RenderTargets targets;
    private IntBuffer pixels = IntBuffer.allocate(0);

    public Renderer(List<Surface> surfaces, List<Overlay> overlays) {
        this.surfaces = List.copyOf(surfaces);
        this.overlays = List.copyOf(overlays);
        surfaces.forEach(s -> boundingBoxes.put(s.name(), BoundingBox.of(s.rest())));
    }

    /** Draws into the framebuffer of this renderer. */
    public void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, int width, int height) {
        draw(gl, frame, camera, style, Tile.whole(width, height));
    }

    /** Draws a part of a picture. */
    void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, Tile tile) {
        long begun = System.nanoTime();
        GlState state = GlState.of(gl);
        objects.resetStatistics();
        if (scene == null) {
            createPasses(gl);
        }
        boolean peeled = style.transparency() == Transparency.PEELED;
        int samples = peeled ? 0 : Math.min(style.samples(), info.maxSamples());
        int scale = peeled && style.samples() > 1 ? 2 : 1;
        resize(gl, tile, scale, samples < 2 ? 0 : samples);
        scene.update(gl, frame, style, fieldValues, fieldVersion);
        scene.setPoses(poses);
        listener.done(gl, "upload");
        ViewTransform sight = ViewTransform.of(camera, tile, scale);
        gl.glDepthMask(true);
        gl.glDisable(GL3.GL_BLEND);
        gl.glPolygonMode(GL3.GL_FRONT_AND_BACK, GL3.GL_FILL);
        drawOpaque(gl, sight, style);
        drawLines(gl, sight, style);
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
        if (style.clip().isPresent()) {
            gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        }
        drawTranslucent(gl, sight, style);
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
        targets.resolve(gl);
        listener.done(gl, "finish");
        state.restore(gl);
        statistics = objects.statistics((System.nanoTime() - begun) / NANOS_PER_MS);
    }

    private void createPasses(GL3 gl) {
        info = GraphicsQuery.info(gl);
        scene = new GpuScene(gl, objects, surfaces, overlays);
        faces = new SurfacePass(objects);
        lines = new LinePass(objects);
        screen = new ScreenPass(gl, objects);
        caps = new CapPass(gl, objects);
        clearPass = new TranslucentPass(faces, screen);
    }

    private void resize(GL3 gl, Tile tile, int scale, int samples) {
        if (targets == null || !targets.matches(tile.width(), tile.height(), scale, samples)) {
            if (targets != null) {
                targets.dispose(gl);
            }
            targets = new RenderTargets(gl, objects, tile.width(), tile.height(), scale, samples);
        }
    }

    private List<SurfaceBuffers> visibleSurfaces(SceneStyle style, boolean clear) {
        return scene.surfaces().stream()
                .filter(s -> style.appearance(s.surface().name())
                        .filter(l -> l.visible() && !l.wireframe() && l.isTranslucent() == clear && l.opacity() > 0)
                        .isPresent())
                .toList();
    }

    private void drawOpaque(GL3 gl, ViewTransform sight, SceneStyle style) {
        targets.drawTarget().bind(gl);
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
        gl.glClear(GL3.GL_DEPTH_BUFFER_BIT | GL3.GL_STENCIL_BUFFER_BIT);
        gl.glDepthFunc(GL3.GL_LESS);
        targets.background(
                gl,
                List.of(style.background(), sight.tile()),
                () -> screen.drawBackground(gl, style.background(), sight));
        listener.done(gl, "background");
        boolean cut = style.clip().isPresent();
        if (cut) {
            gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        }
        gl.glEnable(GL3.GL_DEPTH_TEST);
        List<SurfaceBuffers> shown = visibleSurfaces(style, false).stream()
                .sorted(Comparator.comparing(
                        s -> boundingBoxes.get(s.surface().name()).nearestDepth(sight)))
                .toList();
        for (SurfaceBuffers surface : shown) {
            faces.draw(gl, surface, sight, style, cut ? SurfacePass.Faces.BOTH : SurfacePass.Faces.FRONT);
        }
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
        if (cut) {
            caps.draw(gl, shown, faces, sight, style);
        }
        listener.done(gl, "opaque");
        int depth = targets.depthTexture(gl);
        targets.bindColourOnly(gl);
        int[] part = BoundingBox.screenRectangle(
                shown.stream().map(s -> boundingBoxes.get(s.surface().name())).toList(), sight);
        gl.glEnable(GL3.GL_SCISSOR_TEST);
        gl.glScissor(part[0], part[1], part[2], part[3]);
        screen.darkenDepthEdges(gl, depth, sight);
        gl.glDisable(GL3.GL_SCISSOR_TEST);
        targets.drawTarget().bind(gl);
        listener.done(gl, "edges");
    }

    private void drawLines(GL3 gl, ViewTransform sight, SceneStyle style) {
        List<SurfaceBuffers> wired = scene.surfaces().stream()
                .filter(s -> style.appearance(s.surface().name())
                        .filter(l -> l.visible() && l.wireframe())
                        .isPresent())
                .toList();
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glDepthMask(false);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_SRC_ALPHA, GL3.GL_ONE_MINUS_SRC_ALPHA);
        gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        gl.glEnable(GL3.GL_PROGRAM_POINT_SIZE);
        wired.forEach(s -> lines.drawEdges(gl, s, sight, style));
        if (style.restWireframe()) {
            scene.surfaces().stream()
                    .filter(s -> showsRest(s.surface(), style))
                    .forEach(s -> lines.drawRestEdges(gl, s, sight, style));
        }
        lines.drawOverlays(gl, scene.overlays(), sight, style);
        gl.glDisable(GL3.GL_PROGRAM_POINT_SIZE);
        gl.glDisable(GL3.GL_BLEND);
        gl.glDepthMask(true);
        listener.done(gl, "lines");
    }

    private static boolean showsRest(Surface surface, SceneStyle style) {
        return style.appearance(surface.name()).filter(Appearance::visible).isPresent()
                && surface.motion() != Surface.Motion.STILL
                && (surface.kind() == StructureKind.DIAPHRAGM || style.showsField(surface.name()));
    }

    private void drawTranslucent(GL3 gl, ViewTransform sight, SceneStyle style) {
        List<SurfaceBuffers> clear = visibleSurfaces(style, true).stream()
                .sorted(Comparator.comparing(
                        s -> boundingBoxes.get(s.surface().name()).longestSide()))
                .toList();
        if (clear.isEmpty()) {
            return;
        }
        if (style.transparency() == Transparency.PEELED) {
            clearPass.drawPeeled(gl, targets, clear, sight, style);
        } else {
            clearPass.drawTwoPass(gl, targets, clear, sight, style);
        }
        listener.done(gl, "clear");
    }

    /** The picture, opaque, first row on top. */
    public BufferedImage readPixels(GL3 gl) {
        BufferedImage image =
                new BufferedImage(targets.resolved().width(), targets.resolved().height(), BufferedImage.TYPE_INT_RGB);
        readPixels(gl, image);
        return image;
    }

    /**
     * Copies the picture, first row on top, into an image of its size and of type {@link BufferedImage#TYPE_INT_RGB}.
     *
     * @throws IllegalArgumentException if the image is of another size or type
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
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, targets.resolved().framebuffer());
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
     * Values of {@link ColourField#DISTANCE} or {@link ColourField#ACCESS} on a structure.
     *
     * @throws IllegalArgumentException if there is no such structure or it has another count of vertices
     */
    public void setField(String structure, float[] valuePerVertex) {
        Surface surface = surface(structure);
        int expected = surface.rest().vertexCount();
        if (valuePerVertex.length != expected) {
            throw new IllegalArgumentException(
                    structure + ": found " + valuePerVertex.length + " values, expected one a vertex, " + expected);
        }
        fieldValues.put(structure, valuePerVertex.clone());
        fieldVersion++;
    }

    /**
     * Puts a surface that stands still somewhere else, from the next picture on.
     *
     * @param pose three rows of four: x' = M x + t
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

    /** Gives everything back that the graphics card holds for it. */
    public void dispose(GL3 gl) {
        if (scene != null) {
            scene.dispose(gl);
            faces.dispose(gl);
            lines.dispose(gl);
            screen.dispose(gl);
            caps.dispose(gl);
            scene = null;
        }
        if (targets != null) {
            targets.dispose(gl);
            targets = null;
        }
    }

    /** Objects of OpenGL that are held now. */
    public int liveObjects() {
        return objects.liveCount();
    }

    void setPassListener(PassListener told) {
        listener = told;
    }

    /** What the last picture cost. */
    public FrameStatistics statistics() {
        return statistics;
    }

    /** Surfaces this draws. */
    public List<Surface> surfaces() {
        return surfaces;
    }

    /** Overlays this draws. */
    public List<Overlay> overlays() {
        return overlays;
    }
}
