/**
 * Integration schemes with their amplification matrices and stability limits, and the stepper that splits steps and
 * detects divergence. Forces and constraints do not belong here.
 */
package org.phrenic.engine.integrator;
