/**
 * Geometry of the parametric thorax: implicit surfaces and blends, curves, tubes, ring meshes, marching tetrahedra,
 * mesh relaxation. Independent of any organ.
 */
package org.phrenic.anatomy.virtual.shape;
