/** Files of label volumes: NIfTI, NRRD, MetaImage. */
package org.phrenic.mesh.io.volume;
