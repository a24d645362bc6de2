/** A body is fitted to a second breath level: drives and tissue are tuned until its surfaces lie on those of the scan. */
package org.phrenic.study.fit;
