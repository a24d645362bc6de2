/** Vertex data computed on the CPU (normals, ambient occlusion, field values) and marker meshes. No OpenGL calls. */
package org.phrenic.scene.surface;
