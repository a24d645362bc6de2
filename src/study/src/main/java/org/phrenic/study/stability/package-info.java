/**
 * Stability cases: scenes chosen to break a simulation, the bounds that must hold in each, and their run under every
 * integrator: stable, diverged and recovered, or refused, but never silently wrong. Nothing here is used by a run.
 */
package org.phrenic.study.stability;
