/**
 * Studies on Apache Spark. Runs are tasks of one job; a task that is lost with its machine is computed again elsewhere,
 * and its result has the same bits.
 */
package org.phrenic.cluster;
