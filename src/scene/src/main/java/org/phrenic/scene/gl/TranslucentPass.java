package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.SceneStyle;

/** Draws translucent surfaces over opaque ones, in two passes or by depth peeling (Everitt 2001). */
record TranslucentPass(SurfacePass faces, ScreenPass screen) {
    private static final int LAYER_COUNT = 4;

    /**
     * Draws back faces from the outermost to the innermost surface, then front faces in reverse order.
     *
     * @param surfaces translucent surfaces, innermost first
     */
    void drawTwoPass(
            GL3 gl, RenderTargets targets, List<SurfaceBuffers> surfaces, ViewTransform transform, SceneStyle style) {
        targets.drawTarget().bind(gl);
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_SRC_ALPHA, GL3.GL_ONE_MINUS_SRC_ALPHA);
        gl.glDepthMask(false);
        for (int i = surfaces.size() - 1; i >= 0; i--) {
            faces.draw(gl, surfaces.get(i), transform, style, SurfacePass.Faces.BACK);
        }
        for (SurfaceBuffers surface : surfaces) {
            faces.draw(gl, surface, transform, style, SurfacePass.Faces.FRONT);
        }
        gl.glDepthMask(true);
        gl.glDisable(GL3.GL_BLEND);
    }

    /** Depth peeling: draws the nearest layers of each pixel front to back and blends each under the previous ones. */
    void drawPeeled(
            GL3 gl, RenderTargets targets, List<SurfaceBuffers> surfaces, ViewTransform transform, SceneStyle style) {
        int opaque = targets.depthTexture(gl);
        Framebuffer[] layers = targets.layers(gl);
        Framebuffer accumulation = targets.accumulation(gl);
        gl.glClearColor(0, 0, 0, 0);
        accumulation.bind(gl);
        gl.glClear(GL3.GL_COLOR_BUFFER_BIT);
        for (int i = 0; i < LAYER_COUNT; i++) {
            Framebuffer layer = layers[i % 2];
            layer.bind(gl);
            gl.glClear(GL3.GL_COLOR_BUFFER_BIT | GL3.GL_DEPTH_BUFFER_BIT);
            var between = new SurfacePass.PeelLayer(opaque, layers[(i + 1) % 2].depthTexture(), i == 0);
            for (SurfaceBuffers surface : surfaces) {
                faces.draw(gl, surface, transform, style, SurfacePass.Faces.BOTH, between);
            }
            accumulation.bind(gl);
            blend(gl, layer, GL3.GL_ONE_MINUS_DST_ALPHA, GL3.GL_ONE);
        }
        targets.bindColourOnly(gl);
        blend(gl, accumulation, GL3.GL_ONE, GL3.GL_ONE_MINUS_SRC_ALPHA);
    }

    private void blend(GL3 gl, Framebuffer source, int sourceFactor, int targetFactor) {
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(sourceFactor, targetFactor);
        screen.drawTexture(gl, source.colourTexture());
        gl.glDisable(GL3.GL_BLEND);
    }
}
