/**
 * Organs as nodes, springs and prescribed motions: diaphragm, lungs, sternum, liver. Independent of scene and time
 * stepping.
 */
package org.phrenic.model.organ;
