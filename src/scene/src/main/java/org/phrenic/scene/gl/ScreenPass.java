package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import org.phrenic.scene.camera.Tile;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneBackground;

/** Passes that touch every pixel of a picture: the background, darkened edges, and layers put over each other. */
final class ScreenPass {
    /** A step in depth of this size is as dark as it gets, mm. */
    private static final float MAX_EDGE_DEPTH_MM = 30;

    private static final float EDGE_WIDTH_PIXELS = 1.5f;

    private final GlResources objects;
    private final int emptyVertexArray;
    private final ShaderProgram backdrop;
    private final ShaderProgram edge;
    private final ShaderProgram copy;

    ScreenPass(GL3 gl, GlResources objects) {
        this.objects = objects;
        emptyVertexArray = objects.vertexArray(gl);
        backdrop = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "backdrop.frag.glsl");
        edge = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "edge.frag.glsl");
        copy = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "copy.frag.glsl");
    }

    /** Fills the picture with the background. */
    void drawBackground(GL3 gl, SceneBackground background, ViewTransform sight) {
        backdrop.use(gl);
        backdrop.set(gl, "middle", Appearance.of(background.centreRgb(), 1).rgb());
        backdrop.set(gl, "edge", Appearance.of(background.edgeRgb(), 1).rgb());
        Tile tile = sight.tile();
        int scale = sight.scale();
        backdrop.set(gl, "offset", tile.x() * scale, tile.y() * scale);
        backdrop.set(gl, "whole", tile.wholeWidth() * scale, tile.wholeHeight() * scale);
        drawFullScreen(gl);
    }

    /** Darkens what lies behind its neighbours in the picture; a cue of depth. */
    void darkenDepthEdges(GL3 gl, int depthTexture, ViewTransform sight) {
        edge.use(gl);
        texture(gl, edge, "depth", depthTexture);
        float[] p = sight.fullProjection();
        edge.set(gl, "unproject", p[10], p[14], sight.orthographicFlag());
        edge.set(gl, "reach", MAX_EDGE_DEPTH_MM);
        edge.set(gl, "radius", sight.scaledPixels(EDGE_WIDTH_PIXELS));
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_ZERO, GL3.GL_SRC_COLOR);
        drawFullScreen(gl);
        gl.glDisable(GL3.GL_BLEND);
    }

    /** Draws a texture of colours over the picture; blending is the caller's. */
    void drawTexture(GL3 gl, int colourTexture) {
        copy.use(gl);
        texture(gl, copy, "source", colourTexture);
        drawFullScreen(gl);
    }

    private static void texture(GL3 gl, ShaderProgram program, String name, int texture) {
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, texture);
        program.setSampler(gl, name, 0);
    }

    private void drawFullScreen(GL3 gl) {
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glBindVertexArray(emptyVertexArray);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        objects.countDraw(1);
        gl.glEnable(GL3.GL_DEPTH_TEST);
    }

    void dispose(GL3 gl) {
        objects.deleteVertexArray(gl, emptyVertexArray);
        backdrop.dispose(gl);
        edge.dispose(gl);
        copy.dispose(gl);
    }
}
