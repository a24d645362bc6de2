/** Label volumes in memory and the surface nets that are drawn out of them. */
package org.phrenic.mesh.voxel;
