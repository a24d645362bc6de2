/**
 * Geometric queries on triangle meshes: nearest points, ray and segment intersections, plane cuts, and distances
 * between surfaces with their statistics; clusters of points, for queries of many at a time. Queries do not modify
 * meshes.
 */
package org.phrenic.mesh.query;
