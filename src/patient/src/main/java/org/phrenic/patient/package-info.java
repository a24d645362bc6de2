/**
 * Import of a scan: the structures of a label volume are meshed, checked, reported and written as a thorax folder.
 * Label volumes are in {@link org.phrenic.patient.segmentation}. Template registration and second scans are in
 * {@link org.phrenic.patient.registration}.
 */
package org.phrenic.patient;
