/**
 * From a scan to a body: the structures of a label volume are meshed, checked, reported and written as a thorax folder.
 * Label volumes themselves are in {@link org.phrenic.patient.segmentation}, templates and second scans in
 * {@link org.phrenic.patient.registration}.
 */
package org.phrenic.patient;
