package org.phrenic.scene;

import com.jogamp.opengl.GL3;
import java.util.List;

/** Draws what can be seen through over what cannot: in two passes, or layer by layer (depth peeling, Everitt 2001). */
final class ClearPass {
    private static final int LAYERS = 4;

    private final SurfacePass faces;
    private final ScreenPass screen;

    ClearPass(SurfacePass faces, ScreenPass screen) {
        this.faces = faces;
        this.screen = screen;
    }

    /**
     * Back faces from the outside in, then front faces from the inside out.
     *
     * @param clear surfaces, the innermost first
     */
    void twoPasses(GL3 gl, Targets targets, List<SurfaceBuffers> clear, Sight sight, SceneStyle style) {
        targets.work().bind(gl);
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
    void peel(GL3 gl, Targets targets, List<SurfaceBuffers> clear, Sight sight, SceneStyle style) {
        int opaque = targets.depthSoFar(gl);
        Target[] layers = targets.layers(gl);
        Target gathered = targets.gathered(gl);
        gl.glClearColor(0, 0, 0, 0);
        gathered.bind(gl);
        gl.glClear(GL3.GL_COLOR_BUFFER_BIT);
        for (int i = 0; i < LAYERS; i++) {
            Target layer = layers[i % 2];
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
                        new SurfacePass.Layer(opaque, before, i == 0));
            }
            gathered.bind(gl);
            gl.glEnable(GL3.GL_BLEND);
            gl.glBlendFunc(GL3.GL_ONE_MINUS_DST_ALPHA, GL3.GL_ONE);
            screen.layer(gl, layer.colourTexture());
            gl.glDisable(GL3.GL_BLEND);
        }
        targets.bindColour(gl);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_ONE, GL3.GL_ONE_MINUS_SRC_ALPHA);
        screen.layer(gl, gathered.colourTexture());
        gl.glDisable(GL3.GL_BLEND);
    }
}
