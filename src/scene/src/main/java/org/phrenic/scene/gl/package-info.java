/** The renderer: OpenGL contexts, resources, shaders and passes. The only package that calls OpenGL. */
package org.phrenic.scene.gl;
