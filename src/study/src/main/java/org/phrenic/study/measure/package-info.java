/**
 * Observables computed from the surfaces of a scene at one time: motion of ribs, levels of the domes, zone of
 * apposition, areas, strains.
 */
package org.phrenic.study.measure;
