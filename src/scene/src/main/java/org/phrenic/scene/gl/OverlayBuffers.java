package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.stream.IntStream;
import org.phrenic.simulation.observe.Overlay;

/** GPU buffers of one overlay: lines and points that refer to shared nodes, and fixed lines. */
final class OverlayBuffers {
    private final GlResources resources;
    private final Overlay overlay;
    private final int nodeArray;
    private final int fixedArray;
    private final int lineBuffer;
    private final int pointBuffer;
    private final int lineCount;
    private final int pointCount;

    /** @param nodeBuffer buffer of the node positions, shared by all overlays */
    OverlayBuffers(GL3 gl, GlResources resources, Overlay overlay, int nodeBuffer) {
        this.resources = resources;
        this.overlay = overlay;
        int[] pairs = overlay.nodePairs();
        pointCount = (int) IntStream.range(0, pairs.length / 2)
                .filter(i -> pairs[2 * i] == pairs[2 * i + 1])
                .count();
        lineCount = pairs.length / 2 - pointCount;
        IntBuffer lines = Buffers.newDirectIntBuffer(2 * lineCount);
        IntBuffer points = Buffers.newDirectIntBuffer(pointCount);
        for (int i = 0; i < pairs.length; i += 2) {
            if (pairs[i] == pairs[i + 1]) {
                points.put(pairs[i]);
            } else {
                lines.put(pairs[i]).put(pairs[i + 1]);
            }
        }
        nodeArray = positionArray(gl, nodeBuffer);
        lineBuffer = buffer(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, lines.rewind());
        pointBuffer = buffer(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, points.rewind());
        FloatBuffer segments = Buffers.newDirectFloatBuffer(overlay.segments());
        fixedArray = positionArray(gl, buffer(gl, GL3.GL_ARRAY_BUFFER, segments));
    }

    private int buffer(GL3 gl, int target, Buffer content) {
        return resources.createBuffer(gl, target, content, GL3.GL_STATIC_DRAW);
    }

    private int positionArray(GL3 gl, int positions) {
        int name = resources.create(gl, GlResources.Kind.VERTEX_ARRAY);
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
            drawElements(gl, lineBuffer, GL3.GL_LINES, 2 * lineCount);
            resources.countDraw(2 * lineCount);
        }
        int fixed = overlay.segments().length / 3;
        if (fixed > 0) {
            gl.glBindVertexArray(fixedArray);
            gl.glDrawArrays(GL3.GL_LINES, 0, fixed);
            resources.countDraw(fixed);
        }
    }

    void drawPoints(GL3 gl) {
        drawElements(gl, pointBuffer, GL3.GL_POINTS, pointCount);
        resources.countDraw(0);
    }

    private void drawElements(GL3 gl, int buffer, int primitive, int count) {
        gl.glBindVertexArray(nodeArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, buffer);
        gl.glDrawElements(primitive, count, GL3.GL_UNSIGNED_INT, 0);
    }
}
