package org.phrenic.scene;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;

/** Makes and deletes objects of OpenGL and counts those that live, so that a leak shows; and counts what is sent to them. */
final class GlObjects {
    private int alive;
    private long bytes;
    private int calls;

    /** How many are alive. */
    int alive() {
        return alive;
    }

    /** Begins to count anew what is sent. */
    void startCounting() {
        bytes = 0;
        calls = 0;
    }

    long bytesSent() {
        return bytes;
    }

    int drawCalls() {
        return calls;
    }

    void drew() {
        calls++;
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

    /** Counts a program or any other object made elsewhere. */
    void made() {
        alive++;
    }

    void gone() {
        alive--;
    }

    /** Sends all of a buffer's content. */
    void fill(GL3 gl, int target, Buffer content, int bytesEach, int usage) {
        long size = (long) content.remaining() * bytesEach;
        gl.glBufferData(target, size, content, usage);
        bytes += size;
    }

    /** Sends new content into a buffer of the same size; the old store is let go first, so that nobody waits for a picture that is still being drawn. */
    void refill(GL3 gl, int target, Buffer content, int bytesEach) {
        long size = (long) content.remaining() * bytesEach;
        gl.glBufferData(target, size, null, GL3.GL_STREAM_DRAW);
        gl.glBufferSubData(target, 0, size, content);
        bytes += size;
    }

    void deleteBuffer(GL3 gl, int name) {
        gl.glDeleteBuffers(1, new int[] {name}, 0);
        alive--;
    }

    void deleteVertexArray(GL3 gl, int name) {
        gl.glDeleteVertexArrays(1, new int[] {name}, 0);
        alive--;
    }

    void deleteTexture(GL3 gl, int name) {
        gl.glDeleteTextures(1, new int[] {name}, 0);
        alive--;
    }

    void deleteFramebuffer(GL3 gl, int name) {
        gl.glDeleteFramebuffers(1, new int[] {name}, 0);
        alive--;
    }

    void deleteRenderbuffer(GL3 gl, int name) {
        gl.glDeleteRenderbuffers(1, new int[] {name}, 0);
        alive--;
    }
}
