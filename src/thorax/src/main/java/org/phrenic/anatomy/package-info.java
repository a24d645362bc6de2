/**
 * A thorax as named structures in LPS and mm: reading a folder of meshes, its coordinate frame, and the parts of the
 * diaphragm (faces, central tendon, fibres, crura).
 */
package org.phrenic.anatomy;
