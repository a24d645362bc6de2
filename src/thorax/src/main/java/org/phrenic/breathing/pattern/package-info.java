/**
 * Breathing patterns (periodic, held, coughed, blended, recorded) and the presets that make them. Stateless functions
 * of time.
 */
package org.phrenic.breathing.pattern;
