/**
 * Label volumes and images of files (NIfTI, NRRD, MetaImage, DICOM) in LPS axes and mm. The entry points are
 * {@link org.phrenic.mesh.io.volume.LabelVolumeFiles} and {@link org.phrenic.mesh.io.volume.ImageVolumeFiles}.
 */
package org.phrenic.mesh.io.volume;
