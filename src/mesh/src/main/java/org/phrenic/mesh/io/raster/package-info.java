/**
 * Readers of the formats of volumes that are one block of voxels (NIfTI, NRRD, MetaImage): header, place in LPS and mm,
 * and the stream of stored values, which become labels or an image.
 */
package org.phrenic.mesh.io.raster;
