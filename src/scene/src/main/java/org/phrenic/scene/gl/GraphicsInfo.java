package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;

/**
 * Properties of the OpenGL implementation behind a context.
 *
 * @param renderer {@code GL_RENDERER}
 * @param version {@code GL_VERSION}
 * @param software whether it renders on the CPU
 * @param maxSamples maximum number of samples per pixel
 * @param maxSize maximum side length of a framebuffer, pixels
 */
public record GraphicsInfo(String renderer, String version, boolean software, int maxSamples, int maxSize) {
    private static final List<String> SOFTWARE =
            List.of("llvmpipe", "softpipe", "swrast", "software", "swiftshader", "basic render");

    static GraphicsInfo of(GL3 gl) {
        String renderer = String.valueOf(gl.glGetString(GL3.GL_RENDERER));
        String lower = renderer.toLowerCase(Locale.ROOT);
        return new GraphicsInfo(
                renderer,
                String.valueOf(gl.glGetString(GL3.GL_VERSION)),
                SOFTWARE.stream().anyMatch(lower::contains),
                number(gl, GL3.GL_MAX_SAMPLES),
                Math.min(number(gl, GL3.GL_MAX_RENDERBUFFER_SIZE), number(gl, GL3.GL_MAX_TEXTURE_SIZE)));
    }

    /** What draws, in words. */
    public String description() {
        return renderer + ", OpenGL " + version + (software ? ", on the processor" : "");
    }

    /** Value of an integer state variable ({@code glGetIntegerv}). */
    static int number(GL3 gl, int name) {
        int[] value = new int[1];
        gl.glGetIntegerv(name, value, 0);
        return value[0];
    }
}
