/**
 * Stability cases: scenes chosen to provoke instability, bounds that must hold in each, and their runs under every
 * integrator. A case may be stable, recover from a divergence or be refused, but it must never violate a bound
 * silently.
 */
package org.phrenic.study.stability;
