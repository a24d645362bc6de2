/** Alignment of scans and the warp of a template body to them. */
package org.phrenic.patient.registration;
