/** A simulation that runs on its own thread while it is tuned and displayed. */
package org.phrenic.simulation.live;
