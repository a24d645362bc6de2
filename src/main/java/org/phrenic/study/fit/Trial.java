package org.phrenic.study.fit;

/**
 * A point that was tried.
 *
 * @param values of the parameters
 * @param value what it is worth, smaller is better
 */
public record Trial(double[] values, double value) {}
