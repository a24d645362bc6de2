/** A simulation that is watched and changed while it runs. */
package org.phrenic.simulation.live;
