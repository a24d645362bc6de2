package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.joml.Matrix4d;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Overlay;

/** Draws surface edges and overlays as lines and points with widths in pixels. */
final class LinePass {
    private static final float MIN_EDGE_OPACITY = 0.35f;
    private static final float REST_OPACITY = 0.55f;
    /** Share of the opacity of what a surface hides. */
    private static final float HIDDEN_OPACITY = 0.35f;

    /** Overlays that are seen through surfaces; those that cover a sheet are not, for both sides would mix. */
    private static final Set<Overlay.Kind> SEEN_THROUGH = EnumSet.of(
            Overlay.Kind.RIGID_LINKS, Overlay.Kind.ATTACHMENTS, Overlay.Kind.ACTION_LINES, Overlay.Kind.HELICAL_AXES);

    private static final float EDGE_WIDTH = 1.0f;
    private static final float EDGE_OFFSET_MM = 0.4f;
    private static final int REST_RGB_ON_LIGHT = 0x24405c;
    private static final int REST_RGB_ON_DARK = 0xbfd8ea;

    /**
     * Style of lines and points.
     *
     * @param width line width, pixels
     * @param pointSize point diameter, pixels
     * @param eyeOffset shift towards the eye, mm, which keeps lines on a surface visible
     */
    private record LineStyle(int rgb, float opacity, float width, float pointSize, float eyeOffset) {
        /** Colours of Okabe and Ito 2008, distinguishable with colour vision deficiency. */
        static LineStyle of(Overlay.Kind kind) {
            return switch (kind) {
                case SPRINGS -> new LineStyle(0x56b4e9, 0.55f, 1.0f, 3, 0.6f);
                case RIGID_LINKS -> new LineStyle(0xcc79a7, 1, 2.0f, 4, 1.0f);
                case ATTACHMENTS -> new LineStyle(0xd55e00, 1, 1.6f, ViewTransform.GREATEST_POINT, 2.0f);
                case FIBRES -> new LineStyle(0xf0e442, 0.85f, 1.4f, 3, 0.8f);
                case ACTION_LINES -> new LineStyle(0x009e73, 1, 2.6f, 5, 1.5f);
                case HELICAL_AXES -> new LineStyle(0x0072b2, 1, 2.6f, ViewTransform.GREATEST_POINT, 1.5f);
            };
        }

        /** Of the parts behind a surface. */
        LineStyle hidden() {
            return new LineStyle(rgb, HIDDEN_OPACITY * opacity, width, pointSize, eyeOffset);
        }

        float[] rgba() {
            return LinePass.rgba(Appearance.of(rgb, 1).rgb(), opacity);
        }
    }

    private final GlResources resources;
    private ShaderProgram lines;
    private ShaderProgram points;

    LinePass(GlResources resources) {
        this.resources = resources;
    }

    private static float[] rgba(float[] rgb, float opacity) {
        return new float[] {rgb[0], rgb[1], rgb[2], opacity};
    }

    void drawEdges(GL3 gl, SurfaceBuffers buffers, ViewTransform transform, SceneStyle style) {
        Appearance look = style.appearance(buffers.surface().name()).orElseThrow();
        useLines(gl, transform, style, transform.toEyeSpace(buffers.pose()));
        lines.set(gl, "faded", 1);
        float opacity = Math.max(MIN_EDGE_OPACITY, look.opacity());
        setLine(gl, transform, rgba(look.rgb(), opacity), EDGE_WIDTH, EDGE_OFFSET_MM);
        buffers.drawEdges(gl, false);
    }

    void drawRestEdges(GL3 gl, SurfaceBuffers buffers, ViewTransform transform, SceneStyle style) {
        int rgb = style.background() == SceneBackground.LIGHT ? REST_RGB_ON_LIGHT : REST_RGB_ON_DARK;
        useLines(gl, transform, style, transform.view());
        lines.set(gl, "faded", 0);
        setLine(gl, transform, rgba(Appearance.of(rgb, 1).rgb(), REST_OPACITY), EDGE_WIDTH, EDGE_OFFSET_MM);
        buffers.drawEdges(gl, true);
    }

    /** Draws the chosen overlays; those that run inside the body are faint where a surface hides them. */
    void drawOverlays(GL3 gl, List<OverlayBuffers> overlays, ViewTransform transform, SceneStyle style) {
        for (OverlayBuffers overlay : overlays) {
            if (!style.lines().overlays().contains(overlay.kind())) {
                continue;
            }
            LineStyle drawn = LineStyle.of(overlay.kind());
            draw(gl, overlay, transform, style, drawn);
            if (SEEN_THROUGH.contains(overlay.kind())) {
                gl.glDepthFunc(GL3.GL_GREATER);
                draw(gl, overlay, transform, style, drawn.hidden());
                gl.glDepthFunc(GL3.GL_LESS);
            }
        }
    }

    private void draw(GL3 gl, OverlayBuffers overlay, ViewTransform transform, SceneStyle style, LineStyle drawn) {
        useLines(gl, transform, style, transform.view());
        lines.set(gl, "faded", 0);
        setLine(gl, transform, drawn.rgba(), drawn.width(), drawn.eyeOffset());
        overlay.drawLines(gl);
        if (overlay.hasPoints()) {
            usePoints(gl, transform, style, drawn);
            overlay.drawPoints(gl);
        }
    }

    private void setLine(GL3 gl, ViewTransform transform, float[] rgba, float width, float eyeOffset) {
        lines.set(gl, "lineColour", rgba);
        lines.set(gl, "lineWidth", transform.scaledPixels(width));
        lines.set(gl, "lift", eyeOffset);
    }

    private void useLines(GL3 gl, ViewTransform transform, SceneStyle style, Matrix4d toEye) {
        if (lines == null) {
            lines = new ShaderProgram(gl, resources, "", "line.vert.glsl", "line.geom.glsl", "line.frag.glsl");
        }
        lines.use(gl, transform, style, toEye);
        lines.set(gl, "pixels", transform.width(), transform.height());
    }

    private void usePoints(GL3 gl, ViewTransform transform, SceneStyle style, LineStyle drawn) {
        if (points == null) {
            points = new ShaderProgram(gl, resources, "", "line.vert.glsl", "point.frag.glsl");
        }
        points.use(gl, transform, style, transform.view());
        points.set(gl, "faded", 0);
        points.set(gl, "pointSize", transform.scaledPixels(drawn.pointSize()));
        points.set(gl, "lineColour", drawn.rgba());
        points.set(gl, "lift", drawn.eyeOffset());
    }
}
