package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.SceneStyle;

/** Draws what can be seen through over what cannot: in two passes, or layer by layer (depth peeling, Everitt 2001). */
final class TranslucentPass {
    private static final int LAYER_COUNT = 4;

    private final SurfacePass faces;
    private final ScreenPass screen;

    TranslucentPass(SurfacePass faces, ScreenPass screen) {
        this.faces = faces;
        this.screen = screen;
    }

    /**
     * Back faces from the outside in, then front faces from the inside out.
     *
     * @param clear surfaces, the innermost first
     */
    void drawTwoPass(GL3 gl, RenderTargets targets, List<SurfaceBuffers> clear, ViewTransform sight, SceneStyle style) {
        targets.drawTarget().bind(gl);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_SRC_ALPHA, GL3.GL_ONE_MINUS_SRC_ALPHA);
        gl.glDepthMask(false);
        for (int i = clear.size() - 1; i >= 0; i--) {
            faces.draw(gl, clear.get(i), sight, style, SurfacePass.Faces.BACK);
        }
        for (SurfaceBuffers surface : clear) {
            faces.draw(gl, surface, sight, style, SurfacePass.Faces.FRONT);
        }
        gl.glDepthMask(true);
        gl.glDisable(GL3.GL_BLEND);
    }

    /** The nearest layers of each pixel, from front to back, each put under those before. */
    void drawPeeled(GL3 gl, RenderTargets targets, List<SurfaceBuffers> clear, ViewTransform sight, SceneStyle style) {
        int opaque = targets.depthTexture(gl);
        Framebuffer[] layers = targets.layers(gl);
        Framebuffer gathered = targets.accumulation(gl);
        gl.glClearColor(0, 0, 0, 0);
        gathered.bind(gl);
        gl.glClear(GL3.GL_COLOR_BUFFER_BIT);
        for (int i = 0; i < LAYER_COUNT; i++) {
            Framebuffer layer = layers[i % 2];
            layer.bind(gl);
            gl.glClear(GL3.GL_COLOR_BUFFER_BIT | GL3.GL_DEPTH_BUFFER_BIT);
            int before = layers[(i + 1) % 2].depthTexture();
            for (SurfaceBuffers surface : clear) {
                faces.draw(
                        gl,
                        surface,
                        sight,
                        style,
                        SurfacePass.Faces.BOTH,
                        new SurfacePass.PeelLayer(opaque, before, i == 0));
            }
            gathered.bind(gl);
            gl.glEnable(GL3.GL_BLEND);
            gl.glBlendFunc(GL3.GL_ONE_MINUS_DST_ALPHA, GL3.GL_ONE);
            screen.drawTexture(gl, layer.colourTexture());
            gl.glDisable(GL3.GL_BLEND);
        }
        targets.bindColourOnly(gl);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_ONE, GL3.GL_ONE_MINUS_SRC_ALPHA);
        screen.drawTexture(gl, gathered.colourTexture());
        gl.glDisable(GL3.GL_BLEND);
    }
}
