/**
 * Registration of surfaces: completion of a body from a template
 * ({@link org.phrenic.patient.registration.BodyCompletion}), alignment of a second scan to a first
 * ({@link org.phrenic.patient.registration.ScanAlignment}), distances between lungs, and the underlying transforms and
 * correspondences. The code uses no volume of labels.
 */
package org.phrenic.patient.registration;
