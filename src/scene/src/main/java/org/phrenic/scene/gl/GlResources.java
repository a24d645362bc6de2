package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** Creates OpenGL objects, deletes them together, and counts uploaded bytes, draw calls and triangles. */
final class GlResources {
    /** An OpenGL call that creates or deletes {@code count} objects. */
    private interface Call {
        void apply(GL3 gl, int count, int[] names, int offset);
    }

    /** Kinds of OpenGL objects, in order of deletion. */
    enum Kind {
        FRAMEBUFFER(GL3::glGenFramebuffers, GL3::glDeleteFramebuffers),
        RENDERBUFFER(GL3::glGenRenderbuffers, GL3::glDeleteRenderbuffers),
        TEXTURE(GL3::glGenTextures, GL3::glDeleteTextures),
        VERTEX_ARRAY(GL3::glGenVertexArrays, GL3::glDeleteVertexArrays),
        BUFFER(GL3::glGenBuffers, GL3::glDeleteBuffers),
        PROGRAM(
                (gl, count, names, at) -> names[at] = gl.glCreateProgram(),
                (gl, count, names, at) -> gl.glDeleteProgram(names[at]));

        private final Call create;
        private final Call delete;

        Kind(Call create, Call delete) {
            this.create = create;
            this.delete = delete;
        }
    }

    private final Map<Kind, List<Integer>> live = new EnumMap<>(Kind.class);
    private long bytesUploaded;
    private int drawCalls;
    private long triangles;

    /** Creates an object and returns its OpenGL name. */
    int create(GL3 gl, Kind kind) {
        int[] name = new int[1];
        kind.create.apply(gl, 1, name, 0);
        live.computeIfAbsent(kind, k -> new ArrayList<>()).add(name[0]);
        return name[0];
    }

    void deleteAll(GL3 gl) {
        live.forEach((kind, names) -> names.forEach(name -> kind.delete.apply(gl, 1, new int[] {name}, 0)));
        live.clear();
    }

    int liveCount() {
        return live.values().stream().mapToInt(List::size).sum();
    }

    void resetStatistics() {
        bytesUploaded = 0;
        drawCalls = 0;
        triangles = 0;
    }

    /** Counts since the last reset. */
    FrameStatistics statistics(double cpuMs) {
        return new FrameStatistics(bytesUploaded, drawCalls, cpuMs, triangles);
    }

    void countDraw(int ofTriangles) {
        drawCalls++;
        triangles += ofTriangles;
    }

    /** Creates a buffer of four-byte elements, leaves it bound, and returns its OpenGL name. */
    int createBuffer(GL3 gl, int target, Buffer content, int usage) {
        int name = create(gl, Kind.BUFFER);
        long size = 4L * content.remaining();
        gl.glBindBuffer(target, name);
        gl.glBufferData(target, size, content, usage);
        bytesUploaded += size;
        return name;
    }

    /** Uploads content into newly allocated storage (buffer orphaning). A pending draw call keeps the old storage. */
    void stream(GL3 gl, int name, Buffer content) {
        long size = 4L * content.remaining();
        gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, name);
        gl.glBufferData(GL3.GL_ARRAY_BUFFER, size, null, GL3.GL_STREAM_DRAW);
        gl.glBufferSubData(GL3.GL_ARRAY_BUFFER, 0, size, content);
        bytesUploaded += size;
    }
}
