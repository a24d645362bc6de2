/**
 * Fitting of a body to a second breath level: setup, objective, targets and distances, result and report, and synthetic
 * patients with a known breath. The search algorithms are in {@link org.phrenic.fit.search}.
 */
package org.phrenic.fit;
