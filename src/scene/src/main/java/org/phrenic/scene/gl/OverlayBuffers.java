package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.phrenic.simulation.observe.Overlay;

/**
 * One overlay on the graphics card: lines and points between nodes, which all overlays share, and lines that stay where
 * they are.
 */
final class OverlayBuffers {
    private final GlResources objects;
    private final Overlay overlay;
    private final int nodeArray;
    private final int fixedArray;
    private final int fixedBuffer;
    private final int lineBuffer;
    private final int pointBuffer;
    private final int lineCount;
    private final int pointCount;

    /** @param nodeBuffer where the nodes are */
    OverlayBuffers(GL3 gl, GlResources objects, Overlay overlay, int nodeBuffer) {
        this.objects = objects;
        this.overlay = overlay;
        int[] pairs = overlay.nodePairs();
        int points = 0;
        for (int i = 0; i < pairs.length; i += 2) {
            points += pairs[i] == pairs[i + 1] ? 1 : 0;
        }
        pointCount = points;
        lineCount = pairs.length / 2 - points;
        IntBuffer lines = Buffers.newDirectIntBuffer(2 * lineCount);
        IntBuffer dots = Buffers.newDirectIntBuffer(pointCount);
        for (int i = 0; i < pairs.length; i += 2) {
            if (pairs[i] == pairs[i + 1]) {
                dots.put(pairs[i]);
            } else {
                lines.put(pairs[i]).put(pairs[i + 1]);
            }
        }
        nodeArray = positionArray(gl, nodeBuffer);
        lineBuffer = objects.buffer(gl);
        pointBuffer = objects.buffer(gl);
        objects.upload(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, lineBuffer, lines.rewind(), GL3.GL_STATIC_DRAW);
        objects.upload(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, pointBuffer, dots.rewind(), GL3.GL_STATIC_DRAW);
        fixedBuffer = objects.buffer(gl);
        FloatBuffer fixed = Buffers.newDirectFloatBuffer(overlay.segments());
        objects.upload(gl, GL3.GL_ARRAY_BUFFER, fixedBuffer, fixed, GL3.GL_STATIC_DRAW);
        fixedArray = positionArray(gl, fixedBuffer);
    }

    private int positionArray(GL3 gl, int positions) {
        int name = objects.vertexArray(gl);
        gl.glBindVertexArray(name);
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, positions);
        gl.glEnableVertexAttribArray(0);
        gl.glVertexAttribPointer(0, 3, GL3.GL_FLOAT, false, 0, 0);
        return name;
    }

    Overlay.Kind kind() {
        return overlay.kind();
    }

    boolean hasPoints() {
        return pointCount > 0;
    }

    void drawLines(GL3 gl) {
        if (lineCount > 0) {
            gl.glBindVertexArray(nodeArray);
            gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, lineBuffer);
            gl.glDrawElements(GL3.GL_LINES, 2 * lineCount, GL3.GL_UNSIGNED_INT, 0);
            objects.countDraw(2 * lineCount);
        }
        if (overlay.segments().length > 0) {
            gl.glBindVertexArray(fixedArray);
            gl.glDrawArrays(GL3.GL_LINES, 0, overlay.segments().length / 3);
            objects.countDraw(overlay.segments().length / 3);
        }
    }

    void drawPoints(GL3 gl) {
        gl.glBindVertexArray(nodeArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, pointBuffer);
        gl.glDrawElements(GL3.GL_POINTS, pointCount, GL3.GL_UNSIGNED_INT, 0);
        objects.countDraw(0);
    }

    void dispose(GL3 gl) {
        objects.deleteVertexArray(gl, nodeArray);
        objects.deleteVertexArray(gl, fixedArray);
        objects.deleteBuffer(gl, fixedBuffer);
        objects.deleteBuffer(gl, lineBuffer);
        objects.deleteBuffer(gl, pointBuffer);
    }
}
