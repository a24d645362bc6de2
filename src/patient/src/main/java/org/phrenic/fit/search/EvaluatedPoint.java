package org.phrenic.fit.search;

/**
 * A point that was tried.
 *
 * @param point of the parameters
 * @param value what it is worth, smaller is better
 */
public record EvaluatedPoint(double[] point, double value) {}
