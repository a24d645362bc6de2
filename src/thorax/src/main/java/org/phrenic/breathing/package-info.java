/**
 * What a breath is: its parameters, its waveform, the state that a pattern writes at a time, and recorded traces. No
 * anatomy and no simulation.
 */
package org.phrenic.breathing;
