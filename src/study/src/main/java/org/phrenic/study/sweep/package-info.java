/**
 * Studies of many runs: a study file names factors, a design and responses; a model computes the responses at each
 * point of the design. The subpackages hold designs, their statistics, the execution of the runs and the report.
 */
package org.phrenic.study.sweep;
