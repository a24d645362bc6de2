/** One needle attempt: the insertion frame by frame, its events, targeting errors and record. */
package org.phrenic.access.attempt;
