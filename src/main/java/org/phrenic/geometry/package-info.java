/**
 * Floor 0: triangle meshes and what is done to them (adjacency, welding, bounding-volume tree, distance, remeshing), rigid
 * and helical motions and their fits. Coordinates are millimetres; nothing here knows anatomy, files or forces.
 */
package org.phrenic.geometry;
