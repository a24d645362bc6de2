/** Static equilibrium of a particle system under its constraints, by Newton's method. Time does not advance here. */
package org.phrenic.engine.equilibrium;
