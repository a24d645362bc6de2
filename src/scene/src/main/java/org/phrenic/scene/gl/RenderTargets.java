package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import org.phrenic.scene.camera.ViewTransform;

/** Framebuffers of one picture size. Those for transparency are created on first use. */
final class RenderTargets {
    private static final int ALL_BUFFERS =
            GL3.GL_COLOR_BUFFER_BIT | GL3.GL_DEPTH_BUFFER_BIT | GL3.GL_STENCIL_BUFFER_BIT;

    private final GlResources resources = new GlResources();
    private final int width;
    private final int height;
    private final double scale;
    private final int samples;
    private final Framebuffer drawTarget;
    private final Framebuffer resolved;
    private Framebuffer colourOnly;
    private Framebuffer background;
    private Object backgroundKey = "";
    private Framebuffer still;
    private Framebuffer smoothed;
    private Framebuffer[] layers;
    private Framebuffer accumulation;

    /**
     * @param scale drawn pixels over pixels of the picture along each side
     * @param samples samples per pixel; 0 for no multisampling
     * @throws IllegalStateException if the driver refuses a framebuffer of that size; none is left behind
     */
    RenderTargets(GL3 gl, int width, int height, double scale, int samples) {
        this.width = width;
        this.height = height;
        this.scale = scale;
        this.samples = samples;
        int drawnWidth = ViewTransform.drawn(width, scale);
        int drawnHeight = ViewTransform.drawn(height, scale);
        boolean isCopied = samples > 0 || scale != 1;
        try {
            drawTarget = new Framebuffer(gl, resources, drawnWidth, drawnHeight, samples, true);
            resolved = isCopied ? new Framebuffer(gl, resources, width, height, 0, samples > 0) : drawTarget;
        } catch (RuntimeException | Error e) {
            resources.deleteAll(gl);
            throw e;
        }
    }

    boolean matches(int w, int h, double wantedScale, int wantedSamples) {
        return width == w && height == h && scale == wantedScale && samples == wantedSamples;
    }

    Framebuffer drawTarget() {
        return drawTarget;
    }

    Framebuffer resolved() {
        return resolved;
    }

    /** Texture of the current depth, resolved if multisampled. */
    int depthTexture(GL3 gl) {
        if (samples == 0) {
            return drawTarget.depthTexture();
        }
        drawTarget.blitTo(gl, resolved, GL3.GL_DEPTH_BUFFER_BIT);
        return resolved.depthTexture();
    }

    /** Binds a target without depth texture, so that shaders can read the depth texture. */
    void bindColourOnly(GL3 gl) {
        if (samples == 0 && colourOnly == null) {
            colourOnly = new Framebuffer(gl, resources, drawTarget);
        }
        (samples == 0 ? colourOnly : drawTarget).bind(gl);
    }

    /**
     * Fills the draw target with a background. Without multisampling, the background is cached until the key changes.
     *
     * @param drawing draws the background into the bound framebuffer
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

    /** Whether the draw target can be copied whole: it is not multisampled. */
    boolean canKeepStill() {
        return samples == 0;
    }

    /** Keeps colour and depth of the draw target, which hold what stands still. */
    void keepStill(GL3 gl) {
        if (still == null) {
            still = screen(gl, true);
        }
        drawTarget.blitTo(gl, still, ALL_BUFFERS);
        drawTarget.bind(gl);
    }

    /** Puts back what {@link #keepStill} has kept. */
    void restoreStill(GL3 gl) {
        still.blitTo(gl, drawTarget, ALL_BUFFERS);
        drawTarget.bind(gl);
    }

    private Framebuffer screen(GL3 gl, boolean withDepth) {
        return new Framebuffer(gl, resources, drawTarget.width(), drawTarget.height(), 0, withDepth);
    }

    /** Two framebuffers, used alternately for the layers of depth peeling. */
    Framebuffer[] layers(GL3 gl) {
        if (layers == null) {
            layers = new Framebuffer[] {screen(gl, true), screen(gl, true)};
        }
        return layers;
    }

    /** Framebuffer of the blended layers of depth peeling. */
    Framebuffer accumulation(GL3 gl) {
        if (accumulation == null) {
            accumulation = screen(gl, false);
        }
        return accumulation;
    }

    /** Resolves multisampling and supersampling into the finished picture, or scales a coarse one up. */
    void resolve(GL3 gl, ScreenPass screen) {
        if (scale < 1) {
            if (smoothed == null) {
                smoothed = screen(gl, false);
            }
            smoothed.bind(gl);
            screen.drawAntialiased(gl, drawTarget.colourTexture());
            smoothed.blitTo(gl, resolved, GL3.GL_COLOR_BUFFER_BIT);
        } else if (resolved != drawTarget) {
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
