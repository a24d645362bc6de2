/**
 * B-mode ultrasound of the moving body, computed from its surfaces: probe, beam, echoes, image. No screen, no OpenGL.
 */
package org.phrenic.access.ultrasound;
