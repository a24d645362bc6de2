package org.phrenic.parameter;

/**
 * Search range of a parameter in a fit.
 *
 * @param minimum lower bound, unless the search states others
 * @param maximum upper bound, unless the search states others
 * @param spread initial search width relative to other parameters, above 0, at most 1
 */
public record FitRange(double minimum, double maximum, double spread) {}
