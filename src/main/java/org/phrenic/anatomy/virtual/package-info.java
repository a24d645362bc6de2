/**
 * The virtual thorax: a body at end-expiration grown from a table of measures. One smooth inner chest wall carries everything:
 * ribs, cartilages and sternum lie on its outer side, diaphragm, lungs and liver on its inner side, so that they cannot cross.
 * Axes LPS, mm; {@code x = 0} is the midplane and {@code z = 0} the disc T12/L1.
 */
package org.phrenic.anatomy.virtual;
