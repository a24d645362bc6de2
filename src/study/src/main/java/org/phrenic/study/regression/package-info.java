/** Scenes and exercises computed and compared with stored references, node by node and number by number. */
package org.phrenic.study.regression;
