/** Floor 3: a scenario becomes a running simulation: assembly, clock, observables, recorder. */
package org.phrenic.simulation;
