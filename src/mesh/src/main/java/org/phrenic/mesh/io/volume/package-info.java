/**
 * Readers of volume files (NIfTI-1, NRRD, MetaImage). The entry points are
 * {@link org.phrenic.mesh.io.volume.LabelVolumeFiles} and {@link org.phrenic.mesh.io.volume.ImageVolumeFiles}. The
 * readers convert axes to LPS and lengths to mm.
 */
package org.phrenic.mesh.io.volume;
