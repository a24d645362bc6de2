package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;

/**
 * A framebuffer with eight bits a colour and, where asked for, depth and stencil; of textures, or with several samples
 * a pixel of renderbuffers.
 */
final class Framebuffer {
    private final GlResources objects;
    private final int width;
    private final int height;
    private final int samples;
    private final int framebuffer;
    private final int colour;
    private final int depth;

    /**
     * @param samples 0 for textures
     * @param withDepth whether it has depth of 24 bits and stencil of 8
     * @throws IllegalStateException if the driver refuses it
     */
    Framebuffer(GL3 gl, GlResources objects, int width, int height, int samples, boolean withDepth) {
        this.objects = objects;
        this.width = width;
        this.height = height;
        this.samples = samples;
        framebuffer = objects.framebuffer(gl);
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer);
        colour = attach(gl, GL3.GL_COLOR_ATTACHMENT0, GL3.GL_RGBA8, GL3.GL_RGBA, GL3.GL_UNSIGNED_BYTE);
        depth = withDepth
                ? attach(
                        gl,
                        GL3.GL_DEPTH_STENCIL_ATTACHMENT,
                        GL3.GL_DEPTH24_STENCIL8,
                        GL3.GL_DEPTH_STENCIL,
                        GL3.GL_UNSIGNED_INT_24_8)
                : 0;
        check(gl);
    }

    /** The colour of another target without its depth, so that its depth can be looked up while this is drawn into. */
    Framebuffer(GL3 gl, Framebuffer whose) {
        objects = whose.objects;
        width = whose.width;
        height = whose.height;
        samples = 0;
        colour = 0;
        depth = 0;
        framebuffer = objects.framebuffer(gl);
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer);
        gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, GL3.GL_COLOR_ATTACHMENT0, GL3.GL_TEXTURE_2D, whose.colour, 0);
        check(gl);
    }

    private void check(GL3 gl) {
        int status = gl.glCheckFramebufferStatus(GL3.GL_FRAMEBUFFER);
        if (status != GL3.GL_FRAMEBUFFER_COMPLETE) {
            throw new IllegalStateException("the driver refuses a picture of " + width + " x " + height + " with "
                    + samples + " samples (0x" + Integer.toHexString(status) + ")");
        }
    }

    private int attach(GL3 gl, int where, int format, int transfer, int type) {
        if (samples > 0) {
            int name = objects.renderbuffer(gl);
            gl.glBindRenderbuffer(GL3.GL_RENDERBUFFER, name);
            gl.glRenderbufferStorageMultisample(GL3.GL_RENDERBUFFER, samples, format, width, height);
            gl.glFramebufferRenderbuffer(GL3.GL_FRAMEBUFFER, where, GL3.GL_RENDERBUFFER, name);
            return name;
        }
        int name = objects.texture(gl);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, name);
        gl.glTexImage2D(GL3.GL_TEXTURE_2D, 0, format, width, height, 0, transfer, type, null);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MIN_FILTER, GL3.GL_NEAREST);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_MAG_FILTER, GL3.GL_NEAREST);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_WRAP_S, GL3.GL_CLAMP_TO_EDGE);
        gl.glTexParameteri(GL3.GL_TEXTURE_2D, GL3.GL_TEXTURE_WRAP_T, GL3.GL_CLAMP_TO_EDGE);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, 0);
        gl.glFramebufferTexture2D(GL3.GL_FRAMEBUFFER, where, GL3.GL_TEXTURE_2D, name, 0);
        return name;
    }

    /** From now on is drawn into this. */
    void bind(GL3 gl) {
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, framebuffer);
        gl.glViewport(0, 0, width, height);
    }

    /** Copies to another framebuffer, from corner to corner. */
    void blitTo(GL3 gl, int other, int otherWidth, int otherHeight, int what) {
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, framebuffer);
        gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, other);
        boolean same = width == otherWidth && height == otherHeight;
        gl.glBlitFramebuffer(
                0, 0, width, height, 0, 0, otherWidth, otherHeight, what, same ? GL3.GL_NEAREST : GL3.GL_LINEAR);
    }

    void blitTo(GL3 gl, Framebuffer other, int what) {
        blitTo(gl, other.framebuffer, other.width, other.height, what);
    }

    int framebuffer() {
        return framebuffer;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Texture of colours; for a target of one sample. */
    int colourTexture() {
        return colour;
    }

    /** Texture of depths; for a target of one sample. */
    int depthTexture() {
        return depth;
    }

    void dispose(GL3 gl) {
        objects.deleteFramebuffer(gl, framebuffer);
        for (int name : new int[] {colour, depth}) {
            if (samples > 0) {
                objects.deleteRenderbuffer(gl, name);
            } else {
                objects.deleteTexture(gl, name);
            }
        }
    }
}
