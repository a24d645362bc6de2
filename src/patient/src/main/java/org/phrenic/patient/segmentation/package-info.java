/**
 * Voxels of the structures of a label volume: labels that hold several structures are told apart, holes are filled,
 * broken bones joined. Which label is which structure is in {@link org.phrenic.patient.label}; meshes are created in
 * {@link org.phrenic.patient}.
 */
package org.phrenic.patient.segmentation;
