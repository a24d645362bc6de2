package org.phrenic.scene;

import java.awt.image.BufferedImage;
import org.phrenic.simulation.Frame;

/** OpenGL without a window. */
public final class OffscreenGl implements AutoCloseable {
    private OffscreenGl() {}

    /**
     * A context, without a display where the platform allows it.
     *
     * @throws NoGraphicsException if there is none to be had
     */
    public static OffscreenGl open() throws NoGraphicsException {
        throw new NoGraphicsException("No pictures can be made yet");
    }

    /** Draws one picture of any size. */
    public BufferedImage picture(
            Renderer renderer, Frame frame, Camera camera, SceneStyle style, int width, int height) {
        return new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    }

    /** What draws. */
    public GraphicsInfo info() {
        return new GraphicsInfo("", "", "", true, 0, 0);
    }

    @Override
    public void close() {}
}
