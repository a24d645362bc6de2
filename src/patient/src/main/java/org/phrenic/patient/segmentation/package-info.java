/**
 * Label volumes: which structure each label is, the voxels of the structures, and how labels that hold several
 * structures are split. No meshes; those are made in {@link org.phrenic.patient}.
 */
package org.phrenic.patient.segmentation;
