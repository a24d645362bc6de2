/** Operations that make a mesh of a mesh: repair, remeshing, decimation, smoothing, welding. */
package org.phrenic.mesh.edit;
