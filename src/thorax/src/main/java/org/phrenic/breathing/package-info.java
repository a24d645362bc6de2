/** What breathing asks of muscle, pressure and ribs at a time, and what breathing parameters mean. */
package org.phrenic.breathing;
