/**
 * Operations that return a new triangle mesh: repair, remeshing, decimation, smoothing and splitting into connected
 * components. The half-edge structures are internal to this package.
 */
package org.phrenic.mesh.edit;
