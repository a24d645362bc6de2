/**
 * Reader of DICOM files (PS3.5, PS3.10): data sets of elements and sequences in implicit and explicit transfer syntaxes
 * of either byte order, deflated or not, pixels plain or in run lengths, and the planes of frames (PS3.3, C.7.6.2 and
 * C.7.6.16). The entry point is {@link org.phrenic.mesh.io.dicom.DicomFile}. All counts, lengths and offsets are
 * checked against the file before anything is allocated.
 */
package org.phrenic.mesh.io.dicom;
