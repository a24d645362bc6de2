/** The searches of a fit: CMA-ES, Gauss-Newton, their parameters and journal. */
package org.phrenic.fit.search;
