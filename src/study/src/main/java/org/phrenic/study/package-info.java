/** What studies share: runs, reductions, progress. */
package org.phrenic.study;
