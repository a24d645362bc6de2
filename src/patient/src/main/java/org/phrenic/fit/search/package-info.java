/**
 * Search of a unit cube for the smallest value of an objective: Gauss-Newton in a trust region, CMA-ES, the linear
 * shape model, the tuned parameters and the journal of evaluations. Knows no body, scan or report; those are in
 * {@link org.phrenic.fit}.
 */
package org.phrenic.fit.search;
