/** Threads that share the work of a step with the same bits for any number of them. */
package org.phrenic.engine.parallel;
