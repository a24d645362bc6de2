/** Label maps, mending of labels and the meshes made of them. */
package org.phrenic.patient.segmentation;
