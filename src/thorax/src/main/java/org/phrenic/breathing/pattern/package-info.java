/** Breathing patterns: periodic, held, coughed, blended, traced; and presets that make them. */
package org.phrenic.breathing.pattern;
