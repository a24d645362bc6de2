/** Charts that commands leave beside their results. */
package org.phrenic.cli.chart;
