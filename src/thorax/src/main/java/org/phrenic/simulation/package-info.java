/** A running simulation: steps, records and sums up a scene. */
package org.phrenic.simulation;
