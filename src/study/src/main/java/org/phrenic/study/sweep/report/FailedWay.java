package org.phrenic.study.sweep.report;

/**
 * A way of running a study that did not complete it.
 *
 * @param way such as "Spark local[2]"
 * @param reason one sentence
 */
public record FailedWay(String way, String reason) {}
