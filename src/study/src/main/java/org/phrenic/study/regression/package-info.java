/**
 * Regression tests: scenes and exercises are computed and compared with stored references, node by node and value by
 * value.
 */
package org.phrenic.study.regression;
