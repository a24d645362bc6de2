/** Floor 3: a simulation that runs on a thread of its own while somebody watches and tunes it. Knows no screen. */
package org.phrenic.simulation.live;
