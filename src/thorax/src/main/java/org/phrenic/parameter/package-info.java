/** Declarations of tunable numbers: key, unit, range, default, group. */
package org.phrenic.parameter;
