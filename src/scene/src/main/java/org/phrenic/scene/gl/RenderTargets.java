package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;

/** The framebuffers of a picture of one size; those that transparency needs are made on first use. */
final class RenderTargets {
    private final GlResources resources = new GlResources();
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
    RenderTargets(GL3 gl, int width, int height, int scale, int samples) {
        this.width = width;
        this.height = height;
        this.scale = scale;
        this.samples = samples;
        drawTarget = new Framebuffer(gl, resources, width * scale, height * scale, samples, true);
        resolved =
                samples > 0 || scale > 1 ? new Framebuffer(gl, resources, width, height, 0, samples > 0) : drawTarget;
    }

    boolean matches(int w, int h, int wantedScale, int wantedSamples) {
        return width == w && height == h && scale == wantedScale && samples == wantedSamples;
    }

    /** The framebuffer that surfaces are drawn into. */
    Framebuffer drawTarget() {
        return drawTarget;
    }

    /** The framebuffer of the finished picture. */
    Framebuffer resolved() {
        return resolved;
    }

    /** The present depth as a texture. */
    int depthTexture(GL3 gl) {
        if (samples == 0) {
            return drawTarget.depthTexture();
        }
        drawTarget.blitTo(gl, resolved, GL3.GL_DEPTH_BUFFER_BIT);
        return resolved.depthTexture();
    }

    /** Directs drawing into the colours alone. */
    void bindColourOnly(GL3 gl) {
        if (samples == 0 && colourOnly == null) {
            colourOnly = new Framebuffer(gl, resources, drawTarget);
        }
        (samples == 0 ? colourOnly : drawTarget).bind(gl);
    }

    /**
     * Fills the picture with a background. Without samples it is drawn once for each key and copied from then on.
     *
     * @param drawing draws it into what is bound
     */
    void background(GL3 gl, Object key, Runnable drawing) {
        if (samples > 0) {
            drawTarget.bind(gl);
            drawing.run();
            return;
        }
        if (background == null) {
            background = screen(gl, false);
        }
        if (!key.equals(backgroundKey)) {
            background.bind(gl);
            drawing.run();
            backgroundKey = key;
        }
        background.blitTo(gl, drawTarget, GL3.GL_COLOR_BUFFER_BIT);
        drawTarget.bind(gl);
    }

    private Framebuffer screen(GL3 gl, boolean withDepth) {
        return new Framebuffer(gl, resources, drawTarget.width(), drawTarget.height(), 0, withDepth);
    }

    /** Two framebuffers that take layers in turn. */
    Framebuffer[] layers(GL3 gl) {
        if (layers == null) {
            layers = new Framebuffer[] {screen(gl, true), screen(gl, true)};
        }
        return layers;
    }

    /** Sum of the layers. */
    Framebuffer accumulation(GL3 gl) {
        if (accumulation == null) {
            accumulation = screen(gl, false);
        }
        return accumulation;
    }

    /** Resolves samples and scale into the finished picture. */
    void resolve(GL3 gl) {
        if (resolved != drawTarget) {
            drawTarget.blitTo(gl, resolved, GL3.GL_COLOR_BUFFER_BIT);
        }
    }

    int liveCount() {
        return resources.liveCount();
    }

    void dispose(GL3 gl) {
        resources.deleteAll(gl);
    }
}
