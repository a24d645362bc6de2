/** Floor 4: what is asked of many runs: benchmarks, validation against physiology, sensitivity. */
package org.phrenic.study;
