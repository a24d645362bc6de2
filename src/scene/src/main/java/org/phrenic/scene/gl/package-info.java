/** OpenGL: renderer, passes, buffers, framebuffers, with and without a display. */
package org.phrenic.scene.gl;
