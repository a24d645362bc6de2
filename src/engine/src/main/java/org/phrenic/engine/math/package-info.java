/**
 * Numerical tools: conjugate gradients, dense vectors, sorting, union-find, triangle geometry. This package uses no
 * other package of the engine.
 */
package org.phrenic.engine.math;
