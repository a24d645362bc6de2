/**
 * Which ribs and vertebrae the bones of a segmentation are: they are told apart, and their numbers and sides are
 * brought into line with each other. Their voxels are in {@link org.phrenic.patient.segmentation}.
 */
package org.phrenic.patient.numbering;
