/**
 * Label volumes in memory and the surfaces between their labels (surface nets). File formats are in package
 * {@code mesh.io.volume}.
 */
package org.phrenic.mesh.voxel;
