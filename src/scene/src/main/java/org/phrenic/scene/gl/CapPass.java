package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;

/**
 * Draws the cut faces of bodies that the clip plane cuts open (stencil capping). The stencil buffer counts the faces
 * behind the plane at each pixel: back faces +1, front faces -1. The count is not zero where the line of sight enters
 * the body through the plane; the cap is drawn there.
 */
final class CapPass {
    /** Fraction of white mixed into the colour of a cut face. */
    private static final float LIGHTENING = 0.10f;

    private static final int QUAD_CORNERS = 4;
    /** Polygon offset between successive caps, in smallest resolvable depth steps. */
    private static final float DEPTH_OFFSET_UNITS = 4;

    private final GlResources resources;
    private final ShaderProgram program;
    private final int emptyVertexArray;

    CapPass(GL3 gl, GlResources resources) {
        this.resources = resources;
        program = new ShaderProgram(gl, resources, "", "cap.vert.glsl", "cap.frag.glsl");
        emptyVertexArray = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
    }

    /**
     * Draws the cut faces.
     *
     * @param bodies opaque surfaces; open surfaces, and surfaces that the plane does not cut, get no cap
     */
    void draw(GL3 gl, List<SurfaceBuffers> bodies, SurfacePass faces, ViewTransform transform, SceneStyle style) {
        ClipPlane plane = style.clip().orElseThrow();
        gl.glEnable(GL3.GL_STENCIL_TEST);
        gl.glEnable(GL3.GL_POLYGON_OFFSET_FILL);
        for (int i = 0; i < bodies.size(); i++) {
            SurfaceBuffers body = bodies.get(i);
            BoundingBox box = BoundingBox.of(body.surface().rest());
            if (body.isClosed() && box.mayIntersect(plane)) {
                countFaces(gl, body, faces, transform, style);
                // All caps lie in one plane. The offset draws later bodies (a target in the liver) over earlier ones.
                gl.glPolygonOffset(0, -DEPTH_OFFSET_UNITS * i);
                drawCap(gl, body, box.sectionQuad(plane, transform), transform, style);
            }
        }
        gl.glDisable(GL3.GL_POLYGON_OFFSET_FILL);
        gl.glDisable(GL3.GL_STENCIL_TEST);
    }

    private static void countFaces(
            GL3 gl, SurfaceBuffers body, SurfacePass faces, ViewTransform transform, SceneStyle style) {
        gl.glColorMask(false, false, false, false);
        gl.glDepthMask(false);
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        gl.glStencilFunc(GL3.GL_ALWAYS, 0, 0xff);
        gl.glStencilOpSeparate(GL3.GL_FRONT, GL3.GL_KEEP, GL3.GL_KEEP, GL3.GL_DECR_WRAP);
        gl.glStencilOpSeparate(GL3.GL_BACK, GL3.GL_KEEP, GL3.GL_KEEP, GL3.GL_INCR_WRAP);
        faces.draw(gl, body, transform, style, SurfacePass.Faces.BOTH);
        gl.glColorMask(true, true, true, true);
        gl.glDepthMask(true);
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
    }

    private void drawCap(GL3 gl, SurfaceBuffers body, float[] quad, ViewTransform transform, SceneStyle style) {
        float[] cut =
                style.appearance(body.surface().name()).orElseThrow().rgb().clone();
        for (int i = 0; i < 3; i++) {
            cut[i] += LIGHTENING * (1 - cut[i]);
        }
        program.use(gl);
        program.setMatrix(gl, "projection", transform.projection());
        program.set(gl, "cut", cut);
        program.setPoints(gl, "corners", quad);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glStencilFunc(GL3.GL_NOTEQUAL, 0, 0xff);
        gl.glStencilOp(GL3.GL_ZERO, GL3.GL_ZERO, GL3.GL_ZERO);
        gl.glBindVertexArray(emptyVertexArray);
        gl.glDrawArrays(GL3.GL_TRIANGLE_STRIP, 0, QUAD_CORNERS);
        resources.countDraw(2);
    }
}
