package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;

/**
 * Closes bodies that a plane cuts open (stencil capping). Where a line of sight passes more back faces than front faces
 * of a closed surface behind the plane, it enters the body at the plane: the stencil buffer counts the faces, and the
 * plane is drawn where the count is not zero.
 */
final class CapPass {
    /** Share of white in the colour of a cut face. */
    private static final float LIGHTENING = 0.10f;

    private static final int QUAD_CORNERS = 4;
    /** In smallest resolvable steps of depth. */
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
     * @param bodies opaque surfaces; those that are not closed, or that the plane misses, have none
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
                // All caps lie in one plane: later bodies, such as a target in the liver, are drawn over earlier ones.
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
