package org.phrenic.scene.gl;

/**
 * Statistics of the last picture.
 *
 * @param bytesUploaded bytes uploaded to the GPU since the previous picture
 * @param drawCalls number of draw calls
 * @param cpuMs elapsed time in {@link Renderer#draw}, ms; the GPU may finish later
 * @param triangles number of triangles drawn, summed over all passes
 */
public record FrameStatistics(long bytesUploaded, int drawCalls, double cpuMs, long triangles) {}
