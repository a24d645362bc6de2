/**
 * Cost and error of solver settings (integrator, time step, sweeps, refresh interval) against a reference solution,
 * mesh refinement errors, and the choice of the cheapest setting within an error bound.
 */
package org.phrenic.study.error;
