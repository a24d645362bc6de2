/**
 * Whether a body breathes: dome excursions, return to rest, divergence, organs through the diaphragm; with bodies of
 * random size and shape.
 */
package org.phrenic.study.body;
