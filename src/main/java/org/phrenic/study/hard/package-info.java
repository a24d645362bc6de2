/** Hard cases: scenes chosen to break a simulation, each with what must hold, run with every integrator. Stable, noticed and recovered, or refused: never silent garbage. */
package org.phrenic.study.hard;
