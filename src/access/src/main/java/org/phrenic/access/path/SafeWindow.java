package org.phrenic.access.path;

/**
 * A run of moments of a breath in which a path is free.
 *
 * @param first moment
 * @param last moment; before the first where the run goes on into the next breath
 * @param length how many moments
 */
public record SafeWindow(int first, int last, int length) {}
