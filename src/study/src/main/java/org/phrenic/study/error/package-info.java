/**
 * Integrator, time step, sweeps and refresh interval against a reference solution: error in time and in space against
 * cost, the table of errors, and the choice of a setting from it.
 */
package org.phrenic.study.error;
