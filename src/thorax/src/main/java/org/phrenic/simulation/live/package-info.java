/** A simulation that runs on a thread of its own while it is tuned and watched. */
package org.phrenic.simulation.live;
