/**
 * Breathing patterns (periodic, breath hold, cough, blended, recorded) and presets for them. Patterns are stateless
 * functions of time.
 */
package org.phrenic.breathing.pattern;
