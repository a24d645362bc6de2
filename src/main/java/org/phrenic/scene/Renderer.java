package org.phrenic.scene;

import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import java.util.List;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Surface;

/**
 * Draws a scene with OpenGL 3.3 core into a framebuffer of its own, on a screen or without one. Used by one thread at a time, with its context current; after {@link #dispose} it may be used in
 * another context.
 */
public final class Renderer {
    private final List<Surface> surfaces;
    private final List<Overlay> overlays;
    private final FrameCost cost = new FrameCost(0, 0, 0, 0);

    public Renderer(List<Surface> surfaces, List<Overlay> overlays) {
        this.surfaces = List.copyOf(surfaces);
        this.overlays = List.copyOf(overlays);
    }

    /** Draws into the framebuffer of this renderer. */
    public void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, int width, int height) {
        gl.glClear(GL3.GL_COLOR_BUFFER_BIT);
    }

    void draw(GL3 gl, Frame frame, Camera camera, SceneStyle style, Tile tile) {
        draw(gl, frame, camera, style, tile.width(), tile.height());
    }

    /** Copies the picture into another framebuffer. */
    public void present(GL3 gl, int targetFramebuffer) {
        gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, targetFramebuffer);
    }

    /** The picture, opaque. */
    public BufferedImage read(GL3 gl) {
        return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    }

    /** Values of {@link ColourField#DISTANCE} on a structure. */
    public void setField(String structure, float[] valuePerVertex) {}

    /** Gives everything back that the graphics card holds for it. */
    public void dispose(GL3 gl) {}

    /** What the last picture cost. */
    public FrameCost cost() {
        return cost;
    }

    /** Surfaces this draws. */
    public List<Surface> surfaces() {
        return surfaces;
    }

    /** Overlays this draws. */
    public List<Overlay> overlays() {
        return overlays;
    }
}
