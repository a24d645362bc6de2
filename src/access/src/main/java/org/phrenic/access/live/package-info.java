/**
 * A needle and a probe in a live run: what is asked of them by hand or by a plan, step by step, in the order of the
 * run.
 */
package org.phrenic.access.live;
