/**
 * Readers and writers of surface files (STL, OBJ, PLY, legacy VTK, VTP, PVD) behind
 * {@link org.phrenic.mesh.io.MeshFiles}. A file that cannot be used is refused with a
 * {@link org.phrenic.file.BadInputException} of one sentence.
 */
package org.phrenic.mesh.io;
