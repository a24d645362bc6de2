/** Speed measurements: table 1 of the paper by resolution and forces, and scaling with mesh size and threads. */
package org.phrenic.study.speed;
