/**
 * Triangle meshes: the mesh, its edges and adjacency, its measures, and scalar fields on it; small vector and list
 * helpers. Coordinates are mm. No file, no anatomy, no force; what changes a mesh is in {@code edit}, what searches it
 * in {@code query}.
 */
package org.phrenic.mesh;
