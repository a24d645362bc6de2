/**
 * How work is partitioned and shared: order and blocks of nodes, nodes and edges sorted by block, worker threads.
 * Results have the same bits on any number of threads. No forces here.
 */
package org.phrenic.engine.parallel;
