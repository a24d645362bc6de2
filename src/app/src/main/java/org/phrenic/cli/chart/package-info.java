/** Charts of results as picture files, with JFreeChart. */
package org.phrenic.cli.chart;
