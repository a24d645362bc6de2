/**
 * Minimisation of an objective over the unit cube: Gauss-Newton with a trust region, CMA-ES, the linear shape model,
 * the fitted parameters and the journal of evaluations. The code is independent of bodies, scans and reports, which are
 * in {@link org.phrenic.fit}.
 */
package org.phrenic.fit.search;
