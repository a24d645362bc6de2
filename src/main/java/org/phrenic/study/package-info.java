/** Floor 4: what is asked of many runs: benchmarks and comparisons. */
package org.phrenic.study;
