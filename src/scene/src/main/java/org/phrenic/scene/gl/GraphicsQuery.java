package org.phrenic.scene.gl;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;

/** Asks a context what it is. */
public final class GraphicsQuery {
    private static final List<String> SOFTWARE = List.of("llvmpipe", "softpipe", "swrast", "software", "swiftshader");

    private GraphicsQuery() {}

    public static GraphicsInfo info(GL3 gl) {
        String renderer = text(gl, GL.GL_RENDERER);
        String lower = renderer.toLowerCase(Locale.ROOT);
        return new GraphicsInfo(
                text(gl, GL.GL_VENDOR),
                renderer,
                text(gl, GL.GL_VERSION),
                SOFTWARE.stream().anyMatch(lower::contains),
                number(gl, GL2ES3.GL_MAX_SAMPLES),
                Math.min(number(gl, GL.GL_MAX_RENDERBUFFER_SIZE), number(gl, GL.GL_MAX_TEXTURE_SIZE)));
    }

    private static String text(GL3 gl, int name) {
        return String.valueOf(gl.glGetString(name));
    }

    static int number(GL3 gl, int name) {
        int[] value = new int[1];
        gl.glGetIntegerv(name, value, 0);
        return value[0];
    }
}
