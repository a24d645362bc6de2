/** Static equilibrium of a particle system by Newton's method. */
package org.phrenic.engine.equilibrium;
