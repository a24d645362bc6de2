package org.phrenic.scene;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;

/** Makes and deletes objects of OpenGL and counts those that live, so that a leak shows; and counts what is sent to them and drawn. */
final class GlObjects {
    private int alive;
    private long bytes;
    private int calls;
    private long triangles;

    /** How many are alive. */
    int alive() {
        return alive;
    }

    /** Begins to count anew what is sent and drawn. */
    void startCounting() {
        bytes = 0;
        calls = 0;
        triangles = 0;
    }

    /** What was sent and drawn since counting began. */
    FrameCost cost(double cpuMs) {
        return new FrameCost(bytes, calls, cpuMs, triangles);
    }

    /** Counts a draw call. */
    void drew(int ofTriangles) {
        calls++;
        triangles += ofTriangles;
    }

    int buffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenBuffers(1, name, 0);
        alive++;
        return name[0];
    }

    int vertexArray(GL3 gl) {
        int[] name = new int[1];
        gl.glGenVertexArrays(1, name, 0);
        alive++;
        return name[0];
    }

    int texture(GL3 gl) {
        int[] name = new int[1];
        gl.glGenTextures(1, name, 0);
        alive++;
        return name[0];
    }

    int framebuffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenFramebuffers(1, name, 0);
        alive++;
        return name[0];
    }

    int renderbuffer(GL3 gl) {
        int[] name = new int[1];
        gl.glGenRenderbuffers(1, name, 0);
        alive++;
        return name[0];
    }

    int program(GL3 gl) {
        alive++;
        return gl.glCreateProgram();
    }

    /** Sends all of a buffer's content, in units of four bytes. */
    void fill(GL3 gl, int target, int name, Buffer content, int usage) {
        long size = 4L * content.remaining();
        gl.glBindBuffer(target, name);
        gl.glBufferData(target, size, content, usage);
        bytes += size;
    }

    /** Sends new content; the old store is let go first, so that nobody waits for a picture that is still being drawn from it. */
    void refill(GL3 gl, int name, Buffer content) {
        long size = 4L * content.remaining();
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, name);
        gl.glBufferData(GL3.GL_ARRAY_BUFFER, size, null, GL3.GL_STREAM_DRAW);
        gl.glBufferSubData(GL3.GL_ARRAY_BUFFER, 0, size, content);
        bytes += size;
    }

    /** Deletes a buffer; 0 stands for none, here and below. */
    void deleteBuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteBuffers(1, new int[] {name}, 0);
            alive--;
        }
    }

    void deleteVertexArray(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteVertexArrays(1, new int[] {name}, 0);
            alive--;
        }
    }

    void deleteTexture(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteTextures(1, new int[] {name}, 0);
            alive--;
        }
    }

    void deleteFramebuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteFramebuffers(1, new int[] {name}, 0);
            alive--;
        }
    }

    void deleteRenderbuffer(GL3 gl, int name) {
        if (name != 0) {
            gl.glDeleteRenderbuffers(1, new int[] {name}, 0);
            alive--;
        }
    }

    void deleteProgram(GL3 gl, int name) {
        gl.glDeleteProgram(name);
        alive--;
    }
}
