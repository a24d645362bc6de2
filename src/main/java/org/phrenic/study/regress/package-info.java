/** Regression: scenes computed anew and held against what they gave before, node by node. */
package org.phrenic.study.regress;
