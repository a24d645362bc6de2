/** Plots and timeline: recorded samples, phases of the breath, and the components that draw them over time. */
package org.phrenic.ui.chart;
