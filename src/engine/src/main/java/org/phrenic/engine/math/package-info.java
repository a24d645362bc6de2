/** Small numerical tools: dense vectors, sorting, union-find, triangle geometry. */
package org.phrenic.engine.math;
