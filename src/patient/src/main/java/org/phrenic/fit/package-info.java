/**
 * A body tuned to a second breath level: setup, objective, targets and their distances, result and report, and virtual
 * patients whose breath is known. How points are searched is in {@link org.phrenic.fit.search}.
 */
package org.phrenic.fit;
