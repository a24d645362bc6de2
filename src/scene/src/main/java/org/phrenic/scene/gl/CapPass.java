package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;

/**
 * Draws the cut faces of bodies that the clip plane cuts open (stencil capping). The stencil buffer counts the faces
 * behind the plane at each pixel: back faces +1, front faces -1. The count is not zero where the line of sight enters
 * the body through the plane; the cap is drawn there. Both are confined to the rectangle of the picture that holds the
 * section of the body.
 */
final class CapPass {
    /** Fraction of white mixed into the colour of a cut face. */
    private static final float LIGHTENING = 0.10f;

    private static final int QUAD_CORNERS = 4;

    private final GlResources resources;
    private final ShaderProgram program;
    private final int emptyVertexArray;

    CapPass(GL3 gl, GlResources resources) {
        this.resources = resources;
        program = new ShaderProgram(gl, resources, "", "cap.vert.glsl", "cap.frag.glsl");
        emptyVertexArray = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
    }

    /**
     * Draws the cut faces. All are parts of one square, so that they have the same depth where they overlap, and the
     * later of two bodies (a target in the liver) is drawn over the earlier one.
     *
     * @param bodies opaque surfaces; open surfaces, and surfaces that the plane does not cut, get no cap
     */
    void draw(GL3 gl, List<SurfaceBuffers> bodies, SurfacePass faces, ViewTransform transform, SceneStyle style) {
        ClipPlane plane = style.clip().orElseThrow();
        List<SurfaceBuffers> closed =
                bodies.stream().filter(SurfaceBuffers::isClosed).toList();
        Optional<BoundingBox> around =
                closed.stream().map(b -> b.box().moved(b.pose())).reduce(BoundingBox::with);
        if (around.isEmpty()) {
            return;
        }
        float[] quad = around.get().sectionQuad(plane, transform);
        gl.glEnable(GL3.GL_STENCIL_TEST);
        gl.glEnable(GL3.GL_SCISSOR_TEST);
        gl.glDepthFunc(GL3.GL_LEQUAL);
        for (SurfaceBuffers body : closed) {
            body.box().sectionRectangle(body.pose(), plane, transform).ifPresent(part -> {
                gl.glScissor(part[0], part[1], part[2], part[3]);
                countFaces(gl, body, faces, transform, style);
                drawCap(gl, body, quad, transform, style);
            });
        }
        gl.glDepthFunc(GL3.GL_LESS);
        gl.glDisable(GL3.GL_SCISSOR_TEST);
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
