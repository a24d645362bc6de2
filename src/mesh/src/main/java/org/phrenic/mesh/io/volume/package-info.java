/**
 * Readers of label volume files (NIfTI-1, NRRD, MetaImage) behind {@link org.phrenic.mesh.io.volume.LabelVolumeFiles}.
 * Axes become LPS and lengths mm here, nowhere else.
 */
package org.phrenic.mesh.io.volume;
