/**
 * Time integration schemes behind one interface. Each class shows its scheme and its amplification matrix on the damped oscillator, from which {@link
 * org.phrenic.engine.integrator.StabilityLimit} finds the largest stable step; one contract test runs for all.
 */
package org.phrenic.engine.integrator;
