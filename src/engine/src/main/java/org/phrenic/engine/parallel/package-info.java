/**
 * Partitioning and parallel execution: order and blocks of nodes, nodes and edges sorted by block, worker threads.
 * Results are bitwise identical on any number of threads. Forces do not belong here.
 */
package org.phrenic.engine.parallel;
