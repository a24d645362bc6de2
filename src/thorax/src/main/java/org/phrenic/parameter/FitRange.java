package org.phrenic.parameter;

/**
 * How a search looks for the value of a parameter.
 *
 * @param minimum least value that is tried, where no other bounds are given
 * @param maximum greatest value
 * @param spread how widely it is searched at first beside others, above 0, at most 1
 */
public record FitRange(double minimum, double maximum, double spread) {}
