package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;

/**
 * The OpenGL implementation of a context.
 *
 * @param vendor as the driver states
 * @param renderer as the driver states
 * @param version of OpenGL, as the driver states
 * @param software whether the processor renders in place of a graphics card
 * @param maxSamples most samples a pixel
 * @param maxSize longest side of a picture without tiles, pixels
 */
public record GraphicsInfo(
        String vendor, String renderer, String version, boolean software, int maxSamples, int maxSize) {
    private static final List<String> SOFTWARE = List.of("llvmpipe", "softpipe", "swrast", "software", "swiftshader");

    static GraphicsInfo of(GL3 gl) {
        String renderer = String.valueOf(gl.glGetString(GL3.GL_RENDERER));
        String lower = renderer.toLowerCase(Locale.ROOT);
        return new GraphicsInfo(
                String.valueOf(gl.glGetString(GL3.GL_VENDOR)),
                renderer,
                String.valueOf(gl.glGetString(GL3.GL_VERSION)),
                SOFTWARE.stream().anyMatch(lower::contains),
                number(gl, GL3.GL_MAX_SAMPLES),
                Math.min(number(gl, GL3.GL_MAX_RENDERBUFFER_SIZE), number(gl, GL3.GL_MAX_TEXTURE_SIZE)));
    }

    /** An integer of the context's state. */
    static int number(GL3 gl, int name) {
        int[] value = new int[1];
        gl.glGetIntegerv(name, value, 0);
        return value[0];
    }
}
