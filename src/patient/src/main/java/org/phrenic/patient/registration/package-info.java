/**
 * Registration: transforms and correspondences, by which a template completes a body
 * ({@link org.phrenic.patient.registration.BodyCompletion}) and a second scan is aligned to a first
 * ({@link org.phrenic.patient.registration.ScanAlignment}), and distances between lungs. Label volumes are unknown
 * here.
 */
package org.phrenic.patient.registration;
