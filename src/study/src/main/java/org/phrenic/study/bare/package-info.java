/** The engine alone on a mesh: the workload of benchmarks. */
package org.phrenic.study.bare;
