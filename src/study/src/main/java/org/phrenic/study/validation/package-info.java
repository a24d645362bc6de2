/**
 * Comparison of simulated breaths with published ranges of human physiology: the table of ranges, reductions of time
 * series, verdicts and report, and liver motion.
 */
package org.phrenic.study.validation;
