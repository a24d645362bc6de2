/** Mesh files: STL, OBJ, PLY, VTK, VTP, PVD. */
package org.phrenic.mesh.io;
