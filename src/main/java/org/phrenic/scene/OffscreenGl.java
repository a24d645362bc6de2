package org.phrenic.scene;
import java.awt.image.BufferedImage;
import org.phrenic.simulation.Frame;
public final class OffscreenGl implements AutoCloseable {
    public static OffscreenGl open() throws NoGraphicsException { throw new NoGraphicsException("No OpenGL 3.3 could be had here"); }
    public BufferedImage picture(Renderer r, Frame f, Camera c, SceneStyle s, int w, int h) { return null; }
    public GraphicsInfo info() { return null; }
    public void release(Renderer r) {}
    @Override public void close() {}
}
