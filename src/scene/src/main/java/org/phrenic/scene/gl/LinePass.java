package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Overlay;

/** Draws edges of surfaces and what lies over them as lines and points of a width in pixels. */
final class LinePass {
    private static final float EDGE_WIDTH = 1.0f;
    private static final float REST_WIDTH = 1.0f;
    private static final float EYE_OFFSET_MM = 0.4f;
    private static final int REST_RGB_ON_LIGHT = 0x24405c;
    private static final int REST_RGB_ON_DARK = 0xbfd8ea;

    /** How an overlay is drawn: colour, opacity, width of lines, size of points, lift towards the eye. */
    private record LineStyle(int rgb, float opacity, float width, float pointSize, float eyeOffset) {
        /** Colours of Okabe and Ito 2008, told apart with any colour vision. */
        static LineStyle of(Overlay.Kind kind) {
            return switch (kind) {
                case SPRINGS -> new LineStyle(0x56b4e9, 0.55f, 1.0f, 3, 0.6f);
                case RIGID_LINKS -> new LineStyle(0xcc79a7, 1, 2.0f, 4, 1.0f);
                case ATTACHMENTS -> new LineStyle(0xd55e00, 1, 1.6f, 6, 2.0f);
                case FIBRES -> new LineStyle(0xf0e442, 0.85f, 1.4f, 3, 0.8f);
                case ACTION_LINES -> new LineStyle(0x009e73, 1, 2.6f, 5, 1.5f);
                case HELICAL_AXES -> new LineStyle(0x0072b2, 1, 2.6f, 6, 1.5f);
            };
        }
    }

    private final GlResources objects;
    private ShaderProgram lines;
    private ShaderProgram points;

    LinePass(GlResources objects) {
        this.objects = objects;
    }

    /** Edges of a surface in its own colour. */
    void drawEdges(GL3 gl, SurfaceBuffers buffers, ViewTransform sight, SceneStyle style) {
        Appearance look = style.appearance(buffers.surface().name()).orElseThrow();
        ShaderProgram program = lines(gl, sight, style);
        program.setMatrix(gl, "toEye", sight.toEyeSpace(buffers.pose()));
        program.set(gl, "faded", 1);
        float[] rgb = look.rgb();
        setStyle(
                gl,
                program,
                new float[] {rgb[0], rgb[1], rgb[2], Math.max(0.35f, look.opacity())},
                sight.scaledPixels(EDGE_WIDTH),
                EYE_OFFSET_MM);
        buffers.drawEdges(gl, false);
    }

    /** Edges of a surface as it rests. */
    void drawRestEdges(GL3 gl, SurfaceBuffers buffers, ViewTransform sight, SceneStyle style) {
        ShaderProgram program = lines(gl, sight, style);
        program.setMatrix(gl, "toEye", sight.view());
        program.set(gl, "faded", 0);
        int rgb = style.background() == SceneBackground.LIGHT ? REST_RGB_ON_LIGHT : REST_RGB_ON_DARK;
        setStyle(gl, program, rgba(rgb, 0.55f), sight.scaledPixels(REST_WIDTH), EYE_OFFSET_MM);
        buffers.drawEdges(gl, true);
    }

    /** The overlays that are switched on. */
    void drawOverlays(GL3 gl, List<OverlayBuffers> overlays, ViewTransform sight, SceneStyle style) {
        for (OverlayBuffers overlay : overlays) {
            if (!style.overlays().contains(overlay.kind())) {
                continue;
            }
            LineStyle ink = LineStyle.of(overlay.kind());
            ShaderProgram program = lines(gl, sight, style);
            program.setMatrix(gl, "toEye", sight.view());
            program.set(gl, "faded", 0);
            setStyle(gl, program, rgba(ink.rgb(), ink.opacity()), sight.scaledPixels(ink.width()), ink.eyeOffset());
            overlay.drawLines(gl);
            if (overlay.hasPoints()) {
                ShaderProgram dots = points(gl, sight, style);
                dots.setMatrix(gl, "toEye", sight.view());
                dots.set(gl, "faded", 0);
                dots.set(gl, "pointSize", sight.scaledPixels(ink.pointSize()));
                dots.set(gl, "lineColour", rgba(ink.rgb(), ink.opacity()));
                dots.set(gl, "lift", ink.eyeOffset());
                overlay.drawPoints(gl);
            }
        }
    }

    private static float[] rgba(int rgb, float opacity) {
        float[] c = Appearance.of(rgb, 1).rgb();
        return new float[] {c[0], c[1], c[2], opacity};
    }

    private static void setStyle(GL3 gl, ShaderProgram program, float[] rgba, float width, float lift) {
        program.set(gl, "lineColour", rgba);
        program.set(gl, "lineWidth", width);
        program.set(gl, "lift", lift);
    }

    private ShaderProgram lines(GL3 gl, ViewTransform sight, SceneStyle style) {
        if (lines == null) {
            lines = new ShaderProgram(gl, objects, "", "line.vert.glsl", "line.geom.glsl", "line.frag.glsl");
        }
        setView(gl, lines, sight, style);
        lines.set(gl, "pixels", sight.width(), sight.height());
        return lines;
    }

    private ShaderProgram points(GL3 gl, ViewTransform sight, SceneStyle style) {
        if (points == null) {
            points = new ShaderProgram(gl, objects, "", "line.vert.glsl", "point.frag.glsl");
        }
        setView(gl, points, sight, style);
        return points;
    }

    private static void setView(GL3 gl, ShaderProgram program, ViewTransform sight, SceneStyle style) {
        program.use(gl);
        program.setMatrix(gl, "projection", sight.projection());
        program.set(gl, "clip", sight.clipPlane(style.clip()));
        program.set(gl, "parallel", sight.orthographicFlag());
    }

    void dispose(GL3 gl) {
        if (lines != null) {
            lines.dispose(gl);
        }
        if (points != null) {
            points.dispose(gl);
        }
    }
}
