/** Observables of a scene: domes, volumes, fibres, cage, liver. */
package org.phrenic.simulation.observe;
