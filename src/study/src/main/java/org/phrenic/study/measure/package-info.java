/**
 * Observables computed from the surfaces of a scene at one time: motion of ribs, levels of the domes, zone of
 * apposition, areas, strains. No runs, no statistics over a breath.
 */
package org.phrenic.study.measure;
