/** Parts of a scene: diaphragm, lungs, sternum, liver, skin. */
package org.phrenic.simulation.organ;
