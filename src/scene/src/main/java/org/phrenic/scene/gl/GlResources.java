package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;

/**
 * Makes and deletes objects of OpenGL and counts those that live, so that a leak shows; and counts what is sent to them
 * and drawn.
 */
final class GlResources {
    private int liveCount;
    private long bytesUploaded;
    private int drawCalls;
    private long triangles;

    /** How many are alive. */
    int liveCount() {
        return liveCount;
    }

    /** Begins to count anew what is sent and drawn. */
    void resetStatistics() {
        bytesUploaded = 0;
        drawCalls = 0;
        triangles = 0;
    }

    /** What was sent and drawn since counting began. */
    FrameStatistics statistics(double cpuMs) {
        return new FrameStatistics(bytesUploaded, drawCalls, cpuMs, triangles);
    }

    /** Counts a draw call. */
    void countDraw(int ofTriangles) {
        drawCalls++;
        triangles += ofTriangles;
    }

    int buffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenBuffers(1, name, 0);
        liveCount++;
        return name[0];
    }

    int vertexArray(GL3 gl) {
        int[] name = new int[1];
        gl.glGenVertexArrays(1, name, 0);
        liveCount++;
        return name[0];
    }

    int texture(GL3 gl) {
        int[] name = new int[1];
        gl.glGenTextures(1, name, 0);
        liveCount++;
        return name[0];
    }

    int framebuffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenFramebuffers(1, name, 0);
        liveCount++;
        return name[0];
    }

    int renderbuffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenRenderbuffers(1, name, 0);
        liveCount++;
        return name[0];
    }

    int program(GL3 gl) {
        liveCount++;
        return gl.glCreateProgram();
    }

    /** Sends all of a buffer's content, in units of four bytes. */
    void upload(GL3 gl, int target, int name, Buffer content, int usage) {
        long size = 4L * content.remaining();
        gl.glBindBuffer(target, name);
        gl.glBufferData(target, size, content, usage);
        bytesUploaded += size;
    }

    /**
     * Sends new content; the old store is let go first, so that nobody waits for a picture that is still being drawn
     * from it.
     */
    void stream(GL3 gl, int name, Buffer content) {
        long size = 4L * content.remaining();
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, name);
        gl.glBufferData(GL3.GL_ARRAY_BUFFER, size, null, GL3.GL_STREAM_DRAW);
        gl.glBufferSubData(GL3.GL_ARRAY_BUFFER, 0, size, content);
        bytesUploaded += size;
    }

    /** Deletes a buffer; 0 stands for none, here and below. */
    void deleteBuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteBuffers(1, new int[] {name}, 0);
            liveCount--;
        }
    }

    void deleteVertexArray(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteVertexArrays(1, new int[] {name}, 0);
            liveCount--;
        }
    }

    void deleteTexture(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteTextures(1, new int[] {name}, 0);
            liveCount--;
        }
    }

    void deleteFramebuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteFramebuffers(1, new int[] {name}, 0);
            liveCount--;
        }
    }

    void deleteRenderbuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteRenderbuffers(1, new int[] {name}, 0);
            liveCount--;
        }
    }

    void deleteProgram(GL3 gl, int name) {
        gl.glDeleteProgram(name);
        liveCount--;
    }
}
