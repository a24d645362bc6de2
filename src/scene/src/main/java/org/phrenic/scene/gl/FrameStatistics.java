package org.phrenic.scene.gl;

/**
 * Statistics of the last picture.
 *
 * @param bytesUploaded to the graphics card, since the previous picture
 * @param drawCalls number of draw calls
 * @param cpuMs time in {@link Renderer#draw}, ms; a graphics card finishes later
 * @param triangles drawn, each pass counted
 */
public record FrameStatistics(long bytesUploaded, int drawCalls, double cpuMs, long triangles) {}
