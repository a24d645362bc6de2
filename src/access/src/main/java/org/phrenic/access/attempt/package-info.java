/** One needle attempt: insertion, events, record and errors. */
package org.phrenic.access.attempt;
