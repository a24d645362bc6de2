/** A segmented scan becomes a body. */
package org.phrenic.patient;
