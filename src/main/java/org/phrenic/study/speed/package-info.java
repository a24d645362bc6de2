/** Speed: the paper's table of iterations a second beside what is measured here, and how the cost of a step grows with the number of nodes. */
package org.phrenic.study.speed;
