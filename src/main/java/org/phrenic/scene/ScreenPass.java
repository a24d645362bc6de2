package org.phrenic.scene;

import com.jogamp.opengl.GL3;

/** Passes that touch every pixel of a picture: the background, darkened edges, and layers put over each other. */
final class ScreenPass {
    /** A step in depth of this size is as dark as it gets, mm. */
    private static final float EDGE_REACH_MM = 30;

    private static final float EDGE_PIXELS = 1.5f;

    private final GlObjects objects;
    private final int nothing;
    private final ShaderProgram backdrop;
    private final ShaderProgram edge;
    private final ShaderProgram copy;

    ScreenPass(GL3 gl, GlObjects objects) {
        this.objects = objects;
        nothing = objects.vertexArray(gl);
        backdrop = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "backdrop.frag.glsl");
        edge = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "edge.frag.glsl");
        copy = new ShaderProgram(gl, objects, "", "screen.vert.glsl", "copy.frag.glsl");
    }

    /** Fills the picture with the background. */
    void background(GL3 gl, Background background, Sight sight) {
        backdrop.use(gl);
        backdrop.set(gl, "middle", Look.of(background.middle(), 1).rgb());
        backdrop.set(gl, "edge", Look.of(background.edge(), 1).rgb());
        Tile tile = sight.tile();
        int scale = sight.scale();
        backdrop.set(gl, "offset", tile.x() * scale, tile.y() * scale);
        backdrop.set(gl, "whole", tile.wholeWidth() * scale, tile.wholeHeight() * scale);
        cover(gl);
    }

    /** Darkens what lies behind its neighbours in the picture; a cue of depth. */
    void edges(GL3 gl, int depthTexture, Sight sight) {
        edge.use(gl);
        texture(gl, edge, "depth", depthTexture);
        float[] p = sight.wholeProjection();
        edge.set(gl, "unproject", p[10], p[14], sight.parallelFlag());
        edge.set(gl, "reach", EDGE_REACH_MM);
        edge.set(gl, "radius", sight.pixels(EDGE_PIXELS));
        gl.glEnable(GL3.GL_BLEND);
        gl.glBlendFunc(GL3.GL_ZERO, GL3.GL_SRC_COLOR);
        cover(gl);
        gl.glDisable(GL3.GL_BLEND);
    }

    /** Draws a texture of colours over the picture; blending is the caller's. */
    void layer(GL3 gl, int colourTexture) {
        copy.use(gl);
        texture(gl, copy, "source", colourTexture);
        cover(gl);
    }

    private static void texture(GL3 gl, ShaderProgram program, String name, int texture) {
        gl.glActiveTexture(GL3.GL_TEXTURE0);
        gl.glBindTexture(GL3.GL_TEXTURE_2D, texture);
        program.sampler(gl, name, 0);
    }

    private void cover(GL3 gl) {
        gl.glDisable(GL3.GL_DEPTH_TEST);
        gl.glDisable(GL3.GL_CULL_FACE);
        gl.glBindVertexArray(nothing);
        gl.glDrawArrays(GL3.GL_TRIANGLES, 0, 3);
        objects.drew(1);
        gl.glEnable(GL3.GL_DEPTH_TEST);
    }

    void dispose(GL3 gl) {
        objects.deleteVertexArray(gl, nothing);
        backdrop.dispose(gl);
        edge.dispose(gl);
        copy.dispose(gl);
    }
}
