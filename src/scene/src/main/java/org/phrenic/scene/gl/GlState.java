package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;

/**
 * Bindings of a context, restored after drawing. JOGL's Swing panel draws into its own framebuffer and requires its
 * default vertex array. Without a bound vertex array, core OpenGL reports an error in every picture.
 */
record GlState(int drawFramebuffer, int readFramebuffer, int[] viewport) {
    private static final int TEXTURE_UNITS = 3;

    static GlState of(GL3 gl) {
        int[] viewport = new int[4];
        gl.glGetIntegerv(GL3.GL_VIEWPORT, viewport, 0);
        return new GlState(
                GraphicsInfo.number(gl, GL3.GL_DRAW_FRAMEBUFFER_BINDING),
                GraphicsInfo.number(gl, GL3.GL_READ_FRAMEBUFFER_BINDING),
                viewport);
    }

    void restore(GL3 gl) {
        gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, drawFramebuffer);
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, readFramebuffer);
        gl.glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        gl.glBindVertexArray(gl.getContext().getDefaultVAO());
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, 0);
        gl.glUseProgram(0);
        for (int capability : new int[] {GL3.GL_DEPTH_TEST, GL3.GL_CULL_FACE, GL3.GL_BLEND}) {
            gl.glDisable(capability);
        }
        for (int unit = TEXTURE_UNITS - 1; unit >= 0; unit--) {
            gl.glActiveTexture(GL3.GL_TEXTURE0 + unit);
            gl.glBindTexture(GL3.GL_TEXTURE_2D, 0);
            gl.glBindTexture(GL3.GL_TEXTURE_1D, 0);
        }
    }
}
