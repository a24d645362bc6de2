/** A body tuned to a second breath level: targets, objective, report. */
package org.phrenic.fit;
