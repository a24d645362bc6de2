package org.phrenic.scene.gl;

/**
 * What the last picture cost.
 *
 * @param bytesUploaded to the graphics card, since the picture before
 * @param drawCalls how many
 * @param cpuMs time in {@link Renderer#draw}, ms; on a graphics card it draws on after that
 * @param triangles that were sent, each pass counted
 */
public record FrameStatistics(long bytesUploaded, int drawCalls, double cpuMs, long triangles) {}
