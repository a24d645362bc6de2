/**
 * Observables of a scene (dome motion, volumes, fibre shortening, rib cage, liver) and the frames and surfaces to
 * display.
 */
package org.phrenic.simulation.observe;
