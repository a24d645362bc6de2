/** Writes volumes of real values, labels and displacements: NIfTI-1, NRRD and MetaImage. */
package org.phrenic.mesh.io.image;
