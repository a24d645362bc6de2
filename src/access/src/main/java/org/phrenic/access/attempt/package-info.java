/** A single needle attempt: frame by frame insertion, events, targeting errors and the resulting record. */
package org.phrenic.access.attempt;
