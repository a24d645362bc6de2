/**
 * Triangle meshes: topology, measures, scalar fields, and small vector and list helpers. Coordinates are in mm. Package
 * {@code edit} creates modified meshes, and package {@code query} has geometric queries.
 */
package org.phrenic.mesh;
