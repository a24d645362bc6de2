package org.phrenic.scene;

import com.jogamp.opengl.GL3;
import java.util.List;

/**
 * Closes bodies that a plane has cut open. Where a line of sight passes more back faces than front faces of a closed surface behind the plane, it enters the body at the plane: the stencil buffer counts
 * them, and there the plane is drawn.
 */
final class CapPass {
    /** A cut face is paler than the surface: mixed with this share of white. */
    private static final float PALER = 0.10f;

    private static final int CORNERS = 4;

    /** Of the smallest steps of depth. */
    private static final float NEARER = 4;

    private final GlObjects objects;
    private final ShaderProgram program;
    private final int nothing;

    CapPass(GL3 gl, GlObjects objects) {
        this.objects = objects;
        program = new ShaderProgram(gl, objects, "", "cap.vert.glsl", "cap.frag.glsl");
        nothing = objects.vertexArray(gl);
    }

    /**
     * Draws the cut faces.
     *
     * @param bodies opaque surfaces; those that are not closed, or that the plane misses, have none
     */
    void draw(GL3 gl, List<SurfaceBuffers> bodies, SurfacePass faces, Sight sight, SceneStyle style) {
        ClipPlane plane = style.clip().orElseThrow();
        gl.glEnable(GL3.GL_STENCIL_TEST);
        gl.glEnable(GL3.GL_POLYGON_OFFSET_FILL);
        for (int i = 0; i < bodies.size(); i++) {
            SurfaceBuffers body = bodies.get(i);
            Box box = Box.of(body.surface().rest());
            if (body.isClosed() && box.isNear(plane)) {
                count(gl, body, faces, sight, style);
                // All lie in one plane: what comes later lies over what came before, as a target over the liver about
                // it.
                gl.glPolygonOffset(0, -NEARER * i);
                fill(gl, body, box, plane, sight, style);
            }
        }
        gl.glDisable(GL3.GL_POLYGON_OFFSET_FILL);
        gl.glDisable(GL3.GL_STENCIL_TEST);
    }

    private static void count(GL3 gl, SurfaceBuffers body, SurfacePass faces, Sight sight, SceneStyle style) {
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

    private void fill(GL3 gl, SurfaceBuffers body, Box box, ClipPlane plane, Sight sight, SceneStyle style) {
        float[] rgb = style.look(body.surface().name()).orElseThrow().rgb();
        program.use(gl);
        program.matrix(gl, "projection", sight.projection());
        program.set(
                gl, "cut", rgb[0] + PALER * (1 - rgb[0]), rgb[1] + PALER * (1 - rgb[1]), rgb[2] + PALER * (1 - rgb[2]));
        program.points(gl, "corners", box.section(plane, sight.view()));
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glStencilFunc(GL3.GL_NOTEQUAL, 0, 0xff);
        gl.glStencilOp(GL3.GL_ZERO, GL3.GL_ZERO, GL3.GL_ZERO);
        gl.glBindVertexArray(nothing);
        gl.glDrawArrays(GL3.GL_TRIANGLE_STRIP, 0, CORNERS);
        objects.drew(2);
    }

    void dispose(GL3 gl) {
        program.dispose(gl);
        objects.deleteVertexArray(gl, nothing);
    }
}
