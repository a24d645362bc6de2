/** Statistics of the runs of a study: sensitivity indices with confidence intervals, response curves and bands. */
package org.phrenic.study.sweep.index;
