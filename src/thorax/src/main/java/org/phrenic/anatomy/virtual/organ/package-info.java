/**
 * Organs and vessels of the parametric thorax that the mechanical model does not move: heart, stomach, kidneys, great
 * vessels and others. Each is a union of ellipsoids and swept tubes, cut to the cavity that holds it and to the organs
 * before it in the list, at its stated volume. Axes are LPS in mm as in {@link org.phrenic.anatomy.virtual}.
 */
package org.phrenic.anatomy.virtual.organ;
