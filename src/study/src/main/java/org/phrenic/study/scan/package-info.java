/** What an import of a scan costs: time, memory and the first line of progress, by the number of voxels. */
package org.phrenic.study.scan;
