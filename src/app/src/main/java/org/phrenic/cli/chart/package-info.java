/** Result charts as picture files, drawn with JFreeChart. */
package org.phrenic.cli.chart;
