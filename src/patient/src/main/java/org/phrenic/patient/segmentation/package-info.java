/**
 * Label volumes: assignment of labels to structures, the voxels of the structures, and splitting of labels that contain
 * several structures. Meshes are created in {@link org.phrenic.patient}.
 */
package org.phrenic.patient.segmentation;
