/** Plots, timeline and their data. */
package org.phrenic.ui.chart;
