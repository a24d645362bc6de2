package org.phrenic.scene;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;

/** A framebuffer of one's own: colour and depth as textures, or as multisampled buffers. Made anew when its size changes. */
final class RenderTarget {
    private final GlObjects objects;
    private final boolean hasColour;
    private int framebuffer;
    private int colour;
    private int depth;
    private int width;
    private int height;
    private int samples;

    /** @param hasColour false for depth alone */
    RenderTarget(GlObjects objects, boolean hasColour) {
        this.objects = objects;
        this.hasColour = hasColour;
    }

    int framebuffer() {
        return framebuffer;
    }

    int colourTexture() {
        return colour;
    }

    int depthTexture() {
        return depth;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Binds it for drawing at this size; {@code wanted} samples, 1 for textures that can be read. */
    void bind(GL3 gl, int w, int h, int wanted) {
        if (framebuffer == 0 || w != width || h != height || wanted != samples) {
            dispose(gl);
            make(gl, w, h, wanted);
        }
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer);
        gl.glViewport(0, 0, w, h);
    }

    private void make(GL3 gl, int w, int h, int wanted) {
        width = w;
        height = h;
        samples = wanted;
        framebuffer = objects.framebuffer(gl);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffer);
        if (wanted > 1) {
            colour = renderbuffer(gl, GL.GL_RGBA8, GL.GL_COLOR_ATTACHMENT0);
            depth = renderbuffer(gl, GL.GL_DEPTH_COMPONENT24, GL.GL_DEPTH_ATTACHMENT);
        } else {
            colour = hasColour ? texture(gl, GL.GL_RGBA8, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, GL.GL_COLOR_ATTACHMENT0) : 0;
            depth = texture(
                    gl, GL.GL_DEPTH_COMPONENT24, GL2ES3.GL_DEPTH_COMPONENT, GL.GL_UNSIGNED_INT, GL.GL_DEPTH_ATTACHMENT);
        }
        int status = gl.glCheckFramebufferStatus(GL.GL_FRAMEBUFFER);
        if (status != GL.GL_FRAMEBUFFER_COMPLETE) {
            throw new IllegalStateException("a framebuffer of " + w + " x " + h + " pixels with " + wanted
                    + " samples is refused by the driver");
        }
    }

    private int renderbuffer(GL3 gl, int format, int attachment) {
        int name = objects.renderbuffer(gl);
        gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, name);
        gl.glRenderbufferStorageMultisample(GL.GL_RENDERBUFFER, samples, format, width, height);
        gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, attachment, GL.GL_RENDERBUFFER, name);
        return name;
    }

    private int texture(GL3 gl, int internal, int format, int type, int attachment) {
        int name = objects.texture(gl);
        gl.glBindTexture(GL.GL_TEXTURE_2D, name);
        gl.glTexImage2D(GL.GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, null);
        gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST);
        gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST);
        gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_S, GL.GL_CLAMP_TO_EDGE);
        gl.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_T, GL.GL_CLAMP_TO_EDGE);
        gl.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, attachment, GL.GL_TEXTURE_2D, name, 0);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
        return name;
    }

    /** Copies its colours into another framebuffer, scaled if sizes differ; samples are resolved. */
    void copyTo(GL3 gl, int target, int w, int h) {
        gl.glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, framebuffer);
        gl.glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, target);
        int filter = w == width && h == height ? GL.GL_NEAREST : GL.GL_LINEAR;
        gl.glBlitFramebuffer(0, 0, width, height, 0, 0, w, h, GL.GL_COLOR_BUFFER_BIT, filter);
    }

    void dispose(GL3 gl) {
        if (framebuffer == 0) {
            return;
        }
        objects.deleteFramebuffer(gl, framebuffer);
        framebuffer = 0;
        if (samples > 1) {
            objects.deleteRenderbuffer(gl, colour);
            objects.deleteRenderbuffer(gl, depth);
            return;
        }
        if (colour != 0) {
            objects.deleteTexture(gl, colour);
        }
        objects.deleteTexture(gl, depth);
    }
}
