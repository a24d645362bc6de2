/**
 * What X-ray imaging would show of the moving body: radiographs by the Beer-Lambert law, computed from closed surfaces.
 * Tissues with their physical properties, also for ultrasound. No screen, no OpenGL.
 */
package org.phrenic.access.imaging;
