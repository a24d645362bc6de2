package org.phrenic.scene.gl;

/**
 * What draws.
 *
 * @param vendor as the driver says
 * @param renderer as the driver says
 * @param version of OpenGL, as the driver says
 * @param software whether a processor does the work of a graphics card
 * @param maxSamples most samples a pixel
 * @param maxSize longest side of a picture without tiles
 */
public record GraphicsInfo(
        String vendor, String renderer, String version, boolean software, int maxSamples, int maxSize) {}
