/** Floor 2: file formats. Meshes (STL, OBJ, PLY, VTK, VTP), CSV and YAML; nothing here knows what the numbers mean. */
package org.phrenic.format;
