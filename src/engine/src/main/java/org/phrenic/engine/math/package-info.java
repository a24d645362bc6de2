/**
 * Numerical tools without particles: conjugate gradients, dense vectors, sorting, union-find, triangle geometry.
 * Nothing here uses another package of the engine.
 */
package org.phrenic.engine.math;
