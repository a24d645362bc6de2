/**
 * Contact of the surfaces of soft organs with the diaphragm: which vertices lie beyond the face of their own side, and
 * how an organ is dented there. Contains no forces.
 */
package org.phrenic.anatomy.contact;
