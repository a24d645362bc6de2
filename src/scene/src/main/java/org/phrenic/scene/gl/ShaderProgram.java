package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.joml.Matrix4d;
import org.phrenic.scene.camera.ViewTransform;
import org.phrenic.scene.style.SceneStyle;

/** A GLSL 3.30 program, loaded from the class path, and its uniforms by name. */
final class ShaderProgram {
    private static final String VERSION = "#version 330 core\n";

    private final int program;
    private final Map<String, Integer> locations = new HashMap<>();

    /**
     * @param defines {@code #define} lines that select a variant
     * @param files shader resources of this package; the suffix selects the stage: {@code .vert.glsl},
     *     {@code .geom.glsl}, {@code .frag.glsl}
     * @throws IllegalStateException if a shader does not compile or the program does not link; the message is the
     *     driver's log
     */
    ShaderProgram(GL3 gl, GlResources resources, String defines, String... files) {
        program = resources.create(gl, GlResources.Kind.PROGRAM);
        int[] shaders = new int[files.length];
        for (int i = 0; i < files.length; i++) {
            shaders[i] = compile(gl, defines, files[i]);
            gl.glAttachShader(program, shaders[i]);
        }
        gl.glLinkProgram(program);
        int[] status = new int[1];
        gl.glGetProgramiv(program, GL3.GL_LINK_STATUS, status, 0);
        if (status[0] == 0) {
            throw new IllegalStateException("shaders " + String.join(", ", files) + ": " + log(gl, program, false));
        }
        for (int shader : shaders) {
            gl.glDetachShader(program, shader);
            gl.glDeleteShader(shader);
        }
    }

    private static int compile(GL3 gl, String defines, String file) {
        int type = file.contains(".vert")
                ? GL3.GL_VERTEX_SHADER
                : file.contains(".geom") ? GL3.GL_GEOMETRY_SHADER : GL3.GL_FRAGMENT_SHADER;
        int shader = gl.glCreateShader(type);
        gl.glShaderSource(shader, 1, new String[] {VERSION + defines + source(file)}, null, 0);
        gl.glCompileShader(shader);
        int[] status = new int[1];
        gl.glGetShaderiv(shader, GL3.GL_COMPILE_STATUS, status, 0);
        if (status[0] == 0) {
            throw new IllegalStateException("shader " + file + ": " + log(gl, shader, true));
        }
        return shader;
    }

    private static String source(String file) {
        try (InputStream in = ShaderProgram.class.getResourceAsStream(file)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String log(GL3 gl, int name, boolean shader) {
        byte[] text = new byte[2048];
        int[] length = new int[1];
        if (shader) {
            gl.glGetShaderInfoLog(name, text.length, length, 0, text, 0);
        } else {
            gl.glGetProgramInfoLog(name, text.length, length, 0, text, 0);
        }
        return new String(text, 0, length[0], StandardCharsets.UTF_8).strip();
    }

    void use(GL3 gl) {
        gl.glUseProgram(program);
    }

    /** Activates the program and sets the uniforms of camera and clip plane. */
    void use(GL3 gl, ViewTransform transform, SceneStyle style, Matrix4d toEye) {
        use(gl);
        setMatrix(gl, "toEye", toEye);
        setMatrix(gl, "projection", transform.projection());
        set(gl, "clip", transform.clipPlane(style.clip()));
        set(gl, "parallel", transform.orthographicFlag());
    }

    private int location(GL3 gl, String name) {
        return locations.computeIfAbsent(name, key -> gl.glGetUniformLocation(program, key));
    }

    /** Binds a texture to a texture unit and assigns the unit to a sampler uniform. */
    void setTexture(GL3 gl, String sampler, int unit, int target, int texture) {
        gl.glActiveTexture(GL3.GL_TEXTURE0 + unit);
        gl.glBindTexture(target, texture);
        gl.glUniform1i(location(gl, sampler), unit);
    }

    void set(GL3 gl, String name, float value) {
        gl.glUniform1f(location(gl, name), value);
    }

    /** Sets a uniform vector of two, three or four components. */
    void set(GL3 gl, String name, float... v) {
        switch (v.length) {
            case 2 -> gl.glUniform2f(location(gl, name), v[0], v[1]);
            case 3 -> gl.glUniform3f(location(gl, name), v[0], v[1], v[2]);
            case 4 -> gl.glUniform4f(location(gl, name), v[0], v[1], v[2], v[3]);
            default -> throw new IllegalArgumentException(name + ": found " + v.length + " numbers, expected 2 to 4");
        }
    }

    /** Sets a uniform array of points, x y z each. */
    void setPoints(GL3 gl, String name, float[] xyz) {
        gl.glUniform3fv(location(gl, name), xyz.length / 3, xyz, 0);
    }

    void setMatrix(GL3 gl, String name, Matrix4d matrix) {
        gl.glUniformMatrix4fv(location(gl, name), 1, false, matrix.get(new float[16]), 0);
    }
}
