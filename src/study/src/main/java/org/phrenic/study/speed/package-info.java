/** Speed of scenes and its scaling with size and threads. */
package org.phrenic.study.speed;
