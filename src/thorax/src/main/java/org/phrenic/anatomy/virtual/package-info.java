/**
 * The parametric thorax, generated at end-expiration from a set of measures. All parts are placed relative to one
 * smooth inner chest wall and therefore do not intersect: ribs, cartilages and sternum lie outside it; diaphragm, lungs
 * and liver lie inside. Axes are LPS in mm; {@code x = 0} is the midsagittal plane and {@code z = 0} is the disc
 * T12/L1.
 */
package org.phrenic.anatomy.virtual;
