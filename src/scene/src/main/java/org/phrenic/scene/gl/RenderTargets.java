package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;

/**
 * The framebuffers of a picture of one size: the one that is drawn into, the finished one, and those that transparency
 * asks for; made when first wanted.
 */
final class RenderTargets {
    private final GlResources objects;
    private final int width;
    private final int height;
    private final int scale;
    private final int samples;
    private final Framebuffer drawTarget;
    private final Framebuffer resolved;
    private Framebuffer colourOnly;
    private Framebuffer background;
    private Object backgroundKey = "";
    private Framebuffer[] layers;
    private Framebuffer accumulation;

    /**
     * @param scale pixels drawn for one of the picture, along each side
     * @param samples samples of a pixel, 0 for one
     */
    RenderTargets(GL3 gl, GlResources objects, int width, int height, int scale, int samples) {
        this.objects = objects;
        this.width = width;
        this.height = height;
        this.scale = scale;
        this.samples = samples;
        drawTarget = new Framebuffer(gl, objects, width * scale, height * scale, samples, true);
        resolved = samples > 0 || scale > 1 ? new Framebuffer(gl, objects, width, height, 0, samples > 0) : drawTarget;
    }

    boolean matches(int w, int h, int drawnScale, int drawnSamples) {
        return width == w && height == h && scale == drawnScale && samples == drawnSamples;
    }

    /** What surfaces are drawn into. */
    Framebuffer drawTarget() {
        return drawTarget;
    }

    /** What holds the picture in the end. */
    Framebuffer resolved() {
        return resolved;
    }

    /** The depth of what was drawn so far as a texture. */
    int depthTexture(GL3 gl) {
        if (samples == 0) {
            return drawTarget.depthTexture();
        }
        drawTarget.blitTo(gl, resolved, GL3.GL_DEPTH_BUFFER_BIT);
        return resolved.depthTexture();
    }

    /** Draws into the colours alone. */
    void bindColourOnly(GL3 gl) {
        if (samples > 0) {
            drawTarget.bind(gl);
            return;
        }
        if (colourOnly == null) {
            colourOnly = new Framebuffer(gl, drawTarget);
        }
        colourOnly.bind(gl);
    }

    /**
     * Fills the picture with a background that is drawn once and copied from then on: one of many pixels that do not
     * change.
     *
     * @param what tells backgrounds apart
     * @param drawing draws it into what is bound
     */
    void background(GL3 gl, Object what, Runnable drawing) {
        if (samples > 0) {
            drawTarget.bind(gl);
            drawing.run();
            return;
        }
        if (background == null) {
            background = new Framebuffer(gl, objects, drawTarget.width(), drawTarget.height(), 0, false);
        }
        if (!what.equals(backgroundKey)) {
            background.bind(gl);
            drawing.run();
            backgroundKey = what;
        }
        background.blitTo(gl, drawTarget, GL3.GL_COLOR_BUFFER_BIT);
        drawTarget.bind(gl);
    }

    /** Two framebuffers that take layers in turns. */
    Framebuffer[] layers(GL3 gl) {
        if (layers == null) {
            layers = new Framebuffer[] {
                new Framebuffer(gl, objects, drawTarget.width(), drawTarget.height(), 0, true),
                new Framebuffer(gl, objects, drawTarget.width(), drawTarget.height(), 0, true)
            };
        }
        return layers;
    }

    /** Where layers are put together. */
    Framebuffer accumulation(GL3 gl) {
        if (accumulation == null) {
            accumulation = new Framebuffer(gl, objects, drawTarget.width(), drawTarget.height(), 0, false);
        }
        return accumulation;
    }

    /** Makes the finished picture out of what was drawn. */
    void resolve(GL3 gl) {
        if (resolved != drawTarget) {
            drawTarget.blitTo(gl, resolved, GL3.GL_COLOR_BUFFER_BIT);
        }
    }

    void dispose(GL3 gl) {
        drawTarget.dispose(gl);
        if (resolved != drawTarget) {
            resolved.dispose(gl);
        }
        if (colourOnly != null) {
            colourOnly.dispose(gl);
        }
        if (background != null) {
            background.dispose(gl);
        }
        if (layers != null) {
            layers[0].dispose(gl);
            layers[1].dispose(gl);
        }
        if (accumulation != null) {
            accumulation.dispose(gl);
        }
    }
}
