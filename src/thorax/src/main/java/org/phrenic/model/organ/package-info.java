/** The organs as nodes, springs and motions: diaphragm, lungs, sternum, liver. Knows no scene and no time stepping. */
package org.phrenic.model.organ;
