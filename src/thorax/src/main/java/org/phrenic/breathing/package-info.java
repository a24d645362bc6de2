/**
 * Model of a breath: its parameters, waveform and state at a time, and recorded traces. Independent of anatomy and
 * simulation.
 */
package org.phrenic.breathing;
