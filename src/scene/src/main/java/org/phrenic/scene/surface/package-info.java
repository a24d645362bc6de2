/** What is computed on the processor for each vertex before it is drawn, and meshes of markers. No OpenGL calls. */
package org.phrenic.scene.surface;
