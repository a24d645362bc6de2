/**
 * Geometric queries of triangle meshes: nearest points, rays, segments, plane cuts, distances between surfaces and
 * their statistics. Nothing here changes a mesh.
 */
package org.phrenic.mesh.query;
