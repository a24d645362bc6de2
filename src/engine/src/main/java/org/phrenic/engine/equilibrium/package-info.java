/** Static equilibrium of a particle system under its constraints, by Newton's method. Nothing here advances time. */
package org.phrenic.engine.equilibrium;
