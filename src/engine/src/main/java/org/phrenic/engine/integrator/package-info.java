/**
 * Integration schemes, each with its amplification matrix, their stability limits, and the stepper that splits a step
 * and detects divergence. Forces and constraints do not belong here.
 */
package org.phrenic.engine.integrator;
