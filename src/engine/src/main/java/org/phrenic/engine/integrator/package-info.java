/** Integration schemes, their stability limits, and the stepper that splits a step and guards it against divergence. */
package org.phrenic.engine.integrator;
