/** Floor 2: patterns of breathing and what each drives: muscle activation, pressure, ribs. Times in seconds. */
package org.phrenic.breathing;
