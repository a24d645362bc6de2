package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import org.joml.Matrix4d;
import org.phrenic.scene.camera.Tile;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneBackground;

/** Full-screen passes: background, depth edges, and blending of layers. */
final class ScreenPass {
    /** Depth step at which darkening reaches its maximum, mm. */
    private static final float MAX_EDGE_DEPTH_MM = 30;

    private static final float EDGE_WIDTH_PIXELS = 1.5f;

    private final GlResources resources;
    private final int emptyVertexArray;
    private final ShaderProgram backdrop;
    private final ShaderProgram edge;
    private final ShaderProgram copy;
    private final ShaderProgram antialias;

    ScreenPass(GL3 gl, GlResources resources) {
        this.resources = resources;
        emptyVertexArray = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
        backdrop = new ShaderProgram(gl, resources, "", "screen.vert.glsl", "backdrop.frag.glsl");
        edge = new ShaderProgram(gl, resources, "", "screen.vert.glsl", "edge.frag.glsl");
        copy = new ShaderProgram(gl, resources, "", "screen.vert.glsl", "copy.frag.glsl");
        antialias = new ShaderProgram(gl, resources, "", "screen.vert.glsl", "antialias.frag.glsl");
    }

    void drawBackground(GL3 gl, SceneBackground background, ViewTransform transform) {
        Tile tile = transform.tile();
        float scale = (float) transform.scale();
        backdrop.use(gl);
        backdrop.set(gl, "middle", Appearance.of(background.centreRgb(), 1).rgb());
        backdrop.set(gl, "edge", Appearance.of(background.edgeRgb(), 1).rgb());
        backdrop.set(gl, "offset", tile.x() * scale, tile.y() * scale);
        backdrop.set(gl, "whole", tile.wholeWidth() * scale, tile.wholeHeight() * scale);
        drawFullScreen(gl);
    }

    /** Darkens pixels that lie behind neighbouring pixels, as a depth cue. */
    void darkenDepthEdges(GL3 gl, int depthTexture, ViewTransform transform) {
        Matrix4d p = transform.fullProjection();
        edge.use(gl);
        edge.setTexture(gl, "depth", 0, GL3.GL_TEXTURE_2D, depthTexture);
        edge.set(gl, "unproject", (float) p.m22(), (float) p.m32(), transform.orthographicFlag());
        edge.set(gl, "reach", MAX_EDGE_DEPTH_MM);
        edge.set(gl, "radius", transform.scaledPixels(EDGE_WIDTH_PIXELS));
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_ZERO, GL3.GL_SRC_COLOR);
        drawFullScreen(gl);
        gl.glDisable(GL3.GL_BLEND);
    }

    /** Draws a colour texture over the picture with the blend state set by the caller. */
    void drawTexture(GL3 gl, int colourTexture) {
        draw(gl, copy, colourTexture);
    }

    /** Draws a colour texture with smooth edges (fast approximate antialiasing). */
    void drawAntialiased(GL3 gl, int colourTexture) {
        draw(gl, antialias, colourTexture);
    }

    private void draw(GL3 gl, ShaderProgram program, int colourTexture) {
        program.use(gl);
        program.setTexture(gl, "source", 0, GL3.GL_TEXTURE_2D, colourTexture);
        drawFullScreen(gl);
    }

    private void drawFullScreen(GL3 gl) {
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glBindVertexArray(emptyVertexArray);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        resources.countDraw(1);
        gl.glEnable(GL3.GL_DEPTH_TEST);
    }
}
