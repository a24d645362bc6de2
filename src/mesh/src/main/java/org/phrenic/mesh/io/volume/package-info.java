/**
 * Readers of label volume files (NIfTI-1, NRRD, MetaImage). The entry point is
 * {@link org.phrenic.mesh.io.volume.LabelVolumeFiles}. The readers convert axes to LPS and lengths to mm.
 */
package org.phrenic.mesh.io.volume;
