/** Running simulations: stepping, live changes, recording and summary. */
package org.phrenic.simulation;
