/**
 * Labels of a volume: which structure each one is, by its name or number, and whether structures lie as the stated axes
 * say. Voxels of the structures are in {@link org.phrenic.patient.segmentation}.
 */
package org.phrenic.patient.label;
