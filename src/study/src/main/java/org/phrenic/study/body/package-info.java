/**
 * Whether a body breathes: dome excursions, return to rest, divergence, organs through the diaphragm; with bodies of
 * random size and shape. Also volumes and overlaps of a body's organs.
 */
package org.phrenic.study.body;
