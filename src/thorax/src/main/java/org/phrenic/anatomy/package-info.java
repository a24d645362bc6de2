/**
 * A thorax as named structures in LPS and mm: loading a folder of meshes, the frame it was given in, and the parts of
 * the diaphragm (faces, central tendon, fibres, crura). Nothing here moves and nothing generates a body.
 */
package org.phrenic.anatomy;
