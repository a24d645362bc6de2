/**
 * Steps a second: table 1 of the paper by resolution and forces, and cost against size and threads. Measurements of
 * time only.
 */
package org.phrenic.study.speed;
