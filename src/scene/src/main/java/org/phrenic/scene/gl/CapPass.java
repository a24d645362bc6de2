package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;

/**
 * Closes bodies that a plane has cut open. Where a line of sight passes more back faces than front faces of a closed
 * surface behind the plane, it enters the body at the plane: the stencil buffer counts them, and there the plane is
 * drawn.
 */
final class CapPass {
    /** A cut face is paler than the surface: mixed with this share of white. */
    private static final float LIGHTENING = 0.10f;

    private static final int QUAD_CORNERS = 4;

    /** Of the smallest steps of depth. */
    private static final float DEPTH_OFFSET_UNITS = 4;

    private final GlResources objects;
    private final ShaderProgram program;
    private final int emptyVertexArray;

    CapPass(GL3 gl, GlResources objects) {
        this.objects = objects;
        program = new ShaderProgram(gl, objects, "", "cap.vert.glsl", "cap.frag.glsl");
        emptyVertexArray = objects.vertexArray(gl);
    }

    /**
     * Draws the cut faces.
     *
     * @param bodies opaque surfaces; those that are not closed, or that the plane misses, have none
     */
    void draw(GL3 gl, List<SurfaceBuffers> bodies, SurfacePass faces, ViewTransform sight, SceneStyle style) {
        ClipPlane plane = style.clip().orElseThrow();
        gl.glEnable(GL3.GL_STENCIL_TEST);
        gl.glEnable(GL3.GL_POLYGON_OFFSET_FILL);
        for (int i = 0; i < bodies.size(); i++) {
            SurfaceBuffers body = bodies.get(i);
            BoundingBox box = BoundingBox.of(body.surface().rest());
            if (body.isClosed() && box.mayIntersect(plane)) {
                countFaces(gl, body, faces, sight, style);
                // All lie in one plane: what comes later lies over what came before, as a target over the liver about
                // it.
                gl.glPolygonOffset(0, -DEPTH_OFFSET_UNITS * i);
                drawCap(gl, body, box, plane, sight, style);
            }
        }
        gl.glDisable(GL3.GL_POLYGON_OFFSET_FILL);
        gl.glDisable(GL3.GL_STENCIL_TEST);
    }

    private static void countFaces(
            GL3 gl, SurfaceBuffers body, SurfacePass faces, ViewTransform sight, SceneStyle style) {
        gl.glColorMask(false, false, false, false);
        gl.glDepthMask(false);
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glEnable(GL3.GL_CLIP_DISTANCE0);
        gl.glStencilFunc(GL3.GL_ALWAYS, 0, 0xff);
        gl.glStencilOpSeparate(GL3.GL_FRONT, GL3.GL_KEEP, GL3.GL_KEEP, GL3.GL_DECR_WRAP);
        gl.glStencilOpSeparate(GL3.GL_BACK, GL3.GL_KEEP, GL3.GL_KEEP, GL3.GL_INCR_WRAP);
        faces.draw(gl, body, sight, style, SurfacePass.Faces.BOTH);
        gl.glColorMask(true, true, true, true);
        gl.glDepthMask(true);
        gl.glEnable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CLIP_DISTANCE0);
    }

    private void drawCap(
            GL3 gl, SurfaceBuffers body, BoundingBox box, ClipPlane plane, ViewTransform sight, SceneStyle style) {
        float[] rgb = style.appearance(body.surface().name()).orElseThrow().rgb();
        program.use(gl);
        program.setMatrix(gl, "projection", sight.projection());
        program.set(
                gl,
                "cut",
                rgb[0] + LIGHTENING * (1 - rgb[0]),
                rgb[1] + LIGHTENING * (1 - rgb[1]),
                rgb[2] + LIGHTENING * (1 - rgb[2]));
        program.setPoints(gl, "corners", box.sectionQuad(plane, sight.view()));
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glStencilFunc(GL3.GL_NOTEQUAL, 0, 0xff);
        gl.glStencilOp(GL3.GL_ZERO, GL3.GL_ZERO, GL3.GL_ZERO);
        gl.glBindVertexArray(emptyVertexArray);
        gl.glDrawArrays(GL3.GL_TRIANGLE_STRIP, 0, QUAD_CORNERS);
        objects.countDraw(2);
    }

    void dispose(GL3 gl) {
        program.dispose(gl);
        objects.deleteVertexArray(gl, emptyVertexArray);
    }
}
