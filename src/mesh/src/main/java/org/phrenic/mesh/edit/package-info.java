/**
 * Operations that make a new triangle mesh of another: repair, remeshing, decimation, smoothing, separation into
 * components. Half-edge structures stay in here.
 */
package org.phrenic.mesh.edit;
