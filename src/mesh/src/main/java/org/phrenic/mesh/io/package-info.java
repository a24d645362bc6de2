/**
 * Readers and writers of surface files (STL, OBJ, PLY, legacy VTK, VTP, PVD). The entry point is
 * {@link org.phrenic.mesh.io.MeshFiles}. An invalid file gives a {@link org.phrenic.file.BadInputException} with a
 * message of one sentence.
 */
package org.phrenic.mesh.io;
