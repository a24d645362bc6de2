/**
 * The virtual thorax, generated at end-expiration from a table of measures. One smooth inner chest wall carries
 * everything: ribs, cartilages and sternum lie outside it, diaphragm, lungs and liver inside, so that they cannot
 * intersect. Axes LPS, mm; {@code x = 0} is the midplane and {@code z = 0} the disc T12/L1.
 */
package org.phrenic.anatomy.virtual;
