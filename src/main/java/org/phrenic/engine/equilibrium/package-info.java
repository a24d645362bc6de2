/** Where the nodes of a system come to rest: equilibrium of forces under constraints, by Newton's method. */
package org.phrenic.engine.equilibrium;
