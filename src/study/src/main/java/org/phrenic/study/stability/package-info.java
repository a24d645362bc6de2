/** Hard cases under every integrator, and how each ends. */
package org.phrenic.study.stability;
