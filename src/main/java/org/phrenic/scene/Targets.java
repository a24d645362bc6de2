package org.phrenic.scene;

import com.jogamp.opengl.GL3;

/** The framebuffers of a picture of one size: the one that is drawn into, the finished one, and those that transparency asks for; made when first wanted. */
final class Targets {
    private final GlObjects objects;
    private final int width;
    private final int height;
    private final int scale;
    private final int samples;
    private final Target work;
    private final Target finished;
    private Target workColour;
    private Target background;
    private Object backgroundIs = "";
    private Target[] layers;
    private Target gathered;

    /**
     * @param scale pixels drawn for one of the picture, along each side
     * @param samples samples of a pixel, 0 for one
     */
    Targets(GL3 gl, GlObjects objects, int width, int height, int scale, int samples) {
        this.objects = objects;
        this.width = width;
        this.height = height;
        this.scale = scale;
        this.samples = samples;
        work = new Target(gl, objects, width * scale, height * scale, samples, true);
        finished = samples > 0 || scale > 1 ? new Target(gl, objects, width, height, 0, samples > 0) : work;
    }

    boolean fits(int w, int h, int drawnScale, int drawnSamples) {
        return width == w && height == h && scale == drawnScale && samples == drawnSamples;
    }

    /** What surfaces are drawn into. */
    Target work() {
        return work;
    }

    /** What holds the picture in the end. */
    Target finished() {
        return finished;
    }

    /** The depth of what was drawn so far as a texture. */
    int depthSoFar(GL3 gl) {
        if (samples == 0) {
            return work.depthTexture();
        }
        work.copyTo(gl, finished, GL3.GL_DEPTH_BUFFER_BIT);
        return finished.depthTexture();
    }

    /** Draws into the colours alone. */
    void bindColour(GL3 gl) {
        if (samples > 0) {
            work.bind(gl);
            return;
        }
        if (workColour == null) {
            workColour = new Target(gl, work);
        }
        workColour.bind(gl);
    }

    /**
     * Fills the picture with a background that is drawn once and copied from then on: one of many pixels that do not change.
     *
     * @param what tells backgrounds apart
     * @param drawing draws it into what is bound
     */
    void background(GL3 gl, Object what, Runnable drawing) {
        if (samples > 0) {
            work.bind(gl);
            drawing.run();
            return;
        }
        if (background == null) {
            background = new Target(gl, objects, work.width(), work.height(), 0, false);
        }
        if (!what.equals(backgroundIs)) {
            background.bind(gl);
            drawing.run();
            backgroundIs = what;
        }
        background.copyTo(gl, work, GL3.GL_COLOR_BUFFER_BIT);
        work.bind(gl);
    }

    /** Two framebuffers that take layers in turns. */
    Target[] layers(GL3 gl) {
        if (layers == null) {
            layers = new Target[] {
                new Target(gl, objects, work.width(), work.height(), 0, true),
                new Target(gl, objects, work.width(), work.height(), 0, true)
            };
        }
        return layers;
    }

    /** Where layers are put together. */
    Target gathered(GL3 gl) {
        if (gathered == null) {
            gathered = new Target(gl, objects, work.width(), work.height(), 0, false);
        }
        return gathered;
    }

    /** Makes the finished picture out of what was drawn. */
    void finish(GL3 gl) {
        if (finished != work) {
            work.copyTo(gl, finished, GL3.GL_COLOR_BUFFER_BIT);
        }
    }

    void dispose(GL3 gl) {
        work.dispose(gl);
        if (finished != work) {
            finished.dispose(gl);
        }
        if (workColour != null) {
            workColour.dispose(gl);
        }
        if (background != null) {
            background.dispose(gl);
        }
        if (layers != null) {
            layers[0].dispose(gl);
            layers[1].dispose(gl);
        }
        if (gathered != null) {
            gathered.dispose(gl);
        }
    }
}
