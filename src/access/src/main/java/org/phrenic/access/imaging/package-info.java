/**
 * What imaging would show of the moving body: radiographs by the Beer-Lambert law and B-mode ultrasound, computed from
 * closed surfaces. Tissues with their physical properties, devices, images. No screen, no OpenGL.
 */
package org.phrenic.access.imaging;
