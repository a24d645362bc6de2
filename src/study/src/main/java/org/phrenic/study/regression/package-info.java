/** Scenes held against stored references. */
package org.phrenic.study.regression;
