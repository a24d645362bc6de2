package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;

/**
 * A framebuffer with an RGBA8 colour attachment and, optionally, depth (24 bits) and stencil (8 bits). The attachments
 * are textures, or renderbuffers if multisampled.
 */
final class Framebuffer {
    private final int width;
    private final int height;
    private final int name;
    private final int colour;
    private final int depth;

    /**
     * @param samples samples per pixel; 0 for textures without multisampling
     * @throws IllegalStateException if the framebuffer is incomplete
     */
    Framebuffer(GL3 gl, GlResources resources, int width, int height, int samples, boolean withDepth) {
        this.width = width;
        this.height = height;
        name = resources.create(gl, GlResources.Kind.FRAMEBUFFER);
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, name);
        colour = attach(gl, resources, samples, GL3.GL_COLOR_ATTACHMENT0);
        depth = withDepth ? attach(gl, resources, samples, GL3.GL_DEPTH_STENCIL_ATTACHMENT) : 0;
        check(gl, samples);
    }

    /**
     * Shares the colour texture of another framebuffer and has no depth attachment. Shaders can then read the other's
     * depth texture while drawing into this one.
     */
    Framebuffer(GL3 gl, GlResources resources, Framebuffer whose) {
        width = whose.width;
        height = whose.height;
        colour = 0;
        depth = 0;
        name = resources.create(gl, GlResources.Kind.FRAMEBUFFER);
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, name);
        gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, GL3.GL_COLOR_ATTACHMENT0, GL3.GL_TEXTURE_2D, whose.colour, 0);
        check(gl, 0);
    }

    private void check(GL3 gl, int samples) {
        int status = gl.glCheckFramebufferStatus(GL3.GL_FRAMEBUFFER);
        if (status != GL3.GL_FRAMEBUFFER_COMPLETE) {
            throw new IllegalStateException("the driver refuses a picture of " + width + " x " + height + " with "
                    + samples + " samples (0x" + Integer.toHexString(status) + ")");
        }
    }

    private int attach(GL3 gl, GlResources resources, int samples, int attachment) {
        boolean isColour = attachment == GL3.GL_COLOR_ATTACHMENT0;
        int format = isColour ? GL3.GL_RGBA8 : GL3.GL_DEPTH24_STENCIL8;
        if (samples > 0) {
            int renderbuffer = resources.create(gl, GlResources.Kind.RENDERBUFFER);
            gl.glBindRenderbuffer(GL3.GL_RENDERBUFFER, renderbuffer);
            gl.glRenderbufferStorageMultisample(GL3.GL_RENDERBUFFER, samples, format, width, height);
            gl.glFramebufferRenderbuffer(GL3.GL_FRAMEBUFFER, attachment, GL3.GL_RENDERBUFFER, renderbuffer);
            return renderbuffer;
        }
        int transfer = isColour ? GL3.GL_RGBA : GL3.GL_DEPTH_STENCIL;
        int type = isColour ? GL3.GL_UNSIGNED_BYTE : GL3.GL_UNSIGNED_INT_24_8;
        int texture = resources.create(gl, GlResources.Kind.TEXTURE);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, texture);
        gl.glTexImage2D(GL3.GL_TEXTURE_2D, 0, format, width, height, 0, transfer, type, null);
        int filter = isColour ? GL3.GL_LINEAR : GL3.GL_NEAREST;
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MIN_FILTER, filter);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MAG_FILTER, filter);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_WRAP_S, GL3.GL_CLAMP_TO_EDGE);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_WRAP_T, GL3.GL_CLAMP_TO_EDGE);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, 0);
        gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, attachment, GL3.GL_TEXTURE_2D, texture, 0);
        return texture;
    }

    /** Binds this framebuffer for drawing and sets the viewport to its size. */
    void bind(GL3 gl) {
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, name);
        gl.glViewport(0, 0, width, height);
    }

    /** Copies the buffers selected by a bit mask to another framebuffer, scaled to its size. */
    void blitTo(GL3 gl, Framebuffer other, int mask) {
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, name);
        gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, other.name);
        int filter = width == other.width && height == other.height ? GL3.GL_NEAREST : GL3.GL_LINEAR;
        gl.glBlitFramebuffer(0, 0, width, height, 0, 0, other.width, other.height, mask, filter);
    }

    int name() {
        return name;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Name of the colour texture; a renderbuffer if multisampled. */
    int colourTexture() {
        return colour;
    }

    /** Name of the depth texture; a renderbuffer if multisampled. */
    int depthTexture() {
        return depth;
    }
}
