/**
 * Simulated breaths compared with ranges of human physiology: the table of ranges, reductions of curves to one number,
 * verdicts and their report; motion of the liver beside published ranges.
 */
package org.phrenic.study.validation;
