/** The report of a study: statistics of its responses as tables and as charts in SVG, which need no screen. */
package org.phrenic.study.sweep.report;
