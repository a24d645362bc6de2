/**
 * Geometry that the virtual thorax is built of: implicit surfaces and how they blend, curves, tubes, ring meshes,
 * marching tetrahedra, relaxation. Knows no organ and no measure.
 */
package org.phrenic.anatomy.virtual.shape;
